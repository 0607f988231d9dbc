#include "io/picture/map_svg.hpp"

#include <cstddef>
#include <set>
#include <string>
#include <utility>

#include "drawing/plane_drawing.hpp"
#include "io/picture/map_legend.hpp"
#include "tests/io/picture/xml_check.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

//  0 ---- 1      driven 0 1 2 3 0 and on to 1; each place is an L, 1 has an open gateway north
//  |      |
//  3 ---- 2
namespace {
TopologicalMap square() {
  Trace trace;
  trace.visits = {
      {.star = Star::parse("v+0 h+1 v-1 h-0"), .entered_by = {}, .left_by = 1},
      {.star = Star::parse("v+1 h+0 v-1 h-1"), .entered_by = 3, .left_by = 2},
      {.star = Star::parse("v+1 h+0 v-0 h-1"), .entered_by = 0, .left_by = 3},
      {.star = Star::parse("v+1 h+1 v-0 h-0"), .entered_by = 1, .left_by = 0},
      {.star = Star::parse("v+0 h+1 v-1 h-0"), .entered_by = 2, .left_by = 1},
      {.star = Star::parse("v+1 h+0 v-1 h-1"), .entered_by = 3, .left_by = {}},
  };
  const std::vector<Arrival> arrivals{{PlaceId(0), {}}, {PlaceId(1), 3}, {PlaceId(2), 0},
                                      {PlaceId(3), 1},  {PlaceId(0), 2}, {PlaceId(1), 3}};
  return make_map(trace, arrivals);
}
}  // namespace

TEST_CASE("the picture of a map is well-formed and has every part of it", "[io]") {
  const TopologicalMap map = square();
  const std::string svg = map_svg(map, draw(map), "square");
  CHECK(is_well_formed(svg));
  CHECK(svg.find("<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\"") != std::string::npos);
  CHECK(svg.find("script") == std::string::npos);
  for (const char* text : {">0<", ">3<", "place 0: visits 0, 4", "place 1: visits 1, 5",
                           "0: 0 \u2013 3", "1: 0 \u2013 1"})
    CHECK(svg.find(text) != std::string::npos);
  CHECK(count_of(svg, "text-anchor=\"middle\"") == map.places.size());
  CHECK(count_of(svg, "stroke-dasharray") == 2);  // the open gateway, and the legend's
}

TEST_CASE("a bare picture is the map alone", "[io]") {
  const TopologicalMap map = square();
  const std::string svg = bare_map_svg(map, draw(map), "square");
  CHECK(is_well_formed(svg));
  CHECK(count_of(svg, "<text") == map.places.size());
  CHECK(count_of(svg, "stroke-dasharray") == 1);  // the open gateway
}

TEST_CASE("a title is text, whatever is in it", "[io]") {
  const TopologicalMap map = square();
  const std::string svg = map_svg(map, draw(map), "<b> & \"c\"\x01");
  CHECK(is_well_formed(svg));
  CHECK(svg.find("&lt;b&gt; &amp; &quot;c&quot;?") != std::string::npos);
}

TEST_CASE("the same map gives the same picture", "[io]") {
  const TopologicalMap map = square();
  CHECK(map_svg(map, draw(map), "a") == map_svg(map, draw(map), "a"));
}

TEST_CASE("a hundred paths are told apart by colour and stripe", "[io]") {
  std::set<std::pair<std::string, std::string>> signs;
  for (std::size_t path = 0; path < 100; ++path)
    CHECK(signs.emplace(path_colour(path), path_stripe(path, 5)).second);
  CHECK(path_stripe(11, 5).empty());
}

TEST_CASE("the colours of paths differ in one picture, and one path keeps its own", "[io]") {
  const TopologicalMap map = square();
  const std::string svg = map_svg(map, draw(map), "colours");
  for (const char* colour : {"#0072b2", "#e69f00", "#009e73", "#cc79a7"}) {
    INFO(colour);
    // Two ends in each of two places' discs, a segment and a line of the legend at the least.
    CHECK(count_of(svg, colour) >= 6);
  }
}
