#include "io/picture/clash_svg.hpp"

#include <algorithm>
#include <cmath>
#include <regex>
#include <string>
#include <vector>

#include "drawing/plane_drawing.hpp"
#include "tests/io/picture/xml_check.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

Visit visit(const char* star, std::optional<std::size_t> entered_by,
            std::optional<std::size_t> left_by) {
  return {.star = Star::parse(star), .entered_by = entered_by, .left_by = left_by};
}

/// As many visits as one likes: crossings turned at in every way, dead ends, stars of many arms.
Trace long_trace(std::size_t visits) {
  const std::vector<Visit> kinds{
      visit("v+1 h+1 v-1 h-1", 3, 0),
      visit("v+1 h+1 v-1 h-1", 3, 1),
      visit("v+1 h+1 v-1 h-1", 3, 2),
      visit("a+1 a-0", 0, 0),
      visit("a+1 b+1 c+1 a-1 b-1 c-1", 2, 4),
      visit("a+1 b+1 c+1 d+1 e+1 f+1 a-1 b-1 c-1 d-1 e-1 f-1", 7, 6),
      visit("a+1 b+1 c+1 d+1 a-1 b-1 c-1 d-0", 0, 5),
  };
  Trace trace{.name = "long", .visits = {}};
  for (std::size_t k = 0; k < visits; ++k) trace.visits.push_back(kinds[k % kinds.size()]);
  trace.visits.front().entered_by.reset();
  trace.visits.back().left_by.reset();
  return trace;
}

std::vector<VisitId> visits_of(const std::vector<std::size_t>& numbers) {
  std::vector<VisitId> visits;
  for (const std::size_t k : numbers) visits.emplace_back(k);
  return visits;
}

ClashPicture clash_of_all(const Trace& trace) {
  ClashPicture clash;
  clash.title = "same(0, 3): impossible";
  for (std::size_t k = 0; k < trace.visits.size(); ++k) clash.visits.emplace_back(k);
  clash.said = {{"view", "Equal dstates have equal views. [BMK10, \u00a73.2]"},
                {"same(0, 3)", "what is claimed"}};
  clash.without = {{"visit 0", "visits 1 2 3 at places 0 1 2"}};
  return clash;
}

struct Box {
  double left, top, right, bottom;
  std::string text;
};

bool overlap(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

double number(const std::string& attributes, const std::string& name, double otherwise) {
  const auto at = attributes.find(" " + name + "=\"");
  return at == std::string::npos ? otherwise : std::stod(attributes.substr(at + name.size() + 3));
}

/// Where texts stand, letters taken as 0.56 of their height wide.
std::vector<Box> text_boxes(const std::string& svg) {
  std::vector<Box> boxes;
  const std::regex element("<text([^>]*)>([^<]*)</text>");
  for (std::sregex_iterator it(svg.begin(), svg.end(), element), end; it != end; ++it) {
    const std::string attributes = (*it)[1];
    const std::string text = (*it)[2];
    const double size = number(attributes, "font-size", 13);
    const double width = 0.56 * size * static_cast<double>(text.size());
    const double y = number(attributes, "y", 0);
    double left = number(attributes, "x", 0);
    if (attributes.find("\"middle\"") != std::string::npos) left -= width / 2;
    boxes.push_back({left, y - 0.75 * size, left + width, y + 0.2 * size, text});
  }
  return boxes;
}

std::vector<Box> disc_boxes(const std::string& svg) {
  std::vector<Box> boxes;
  const std::regex element("<circle([^>]*)/>");
  for (std::sregex_iterator it(svg.begin(), svg.end(), element), end; it != end; ++it) {
    const std::string attributes = (*it)[1];
    const double x = number(attributes, "cx", 0);
    const double y = number(attributes, "cy", 0);
    const double r = number(attributes, "r", 0);
    boxes.push_back({x - r, y - r, x + r, y + r, ""});
  }
  return boxes;
}

/// All points that straight pieces begin or end at.
std::vector<MapDrawing::Point> corners(const std::string& svg, const std::string& style) {
  std::vector<MapDrawing::Point> points;
  const std::regex element("<path d=\"([^\"]*)\" ([^>]*)/>");
  const std::regex pair("(-?[0-9.]+) (-?[0-9.]+)");
  for (std::sregex_iterator it(svg.begin(), svg.end(), element), end; it != end; ++it) {
    if ((*it)[2].str().find(style) == std::string::npos) continue;
    const std::string d = (*it)[1];
    for (std::sregex_iterator at(d.begin(), d.end(), pair), last; at != last; ++at)
      points.push_back({std::stod((*at)[1]), std::stod((*at)[2])});
  }
  return points;
}

const char* const travel_style = "fill=\"none\" stroke=\"#222222\" stroke-width=\"2\"";

void check_layout(const std::string& svg) {
  CHECK(is_well_formed(svg));
  CHECK(svg.find("nan") == std::string::npos);
  CHECK(svg.find("inf\"") == std::string::npos);
  const std::vector<Box> texts = text_boxes(svg);
  const std::vector<Box> discs = disc_boxes(svg);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    INFO(texts[i].text);
    for (std::size_t j = 0; j < i; ++j) {
      INFO(texts[j].text);
      CHECK_FALSE(overlap(texts[i], texts[j]));
    }
    const bool is_number = texts[i].text.find_first_not_of("0123456789") == std::string::npos;
    if (!is_number)
      CHECK(std::ranges::none_of(discs, [&](const Box& disc) { return overlap(disc, texts[i]); }));
    CHECK(texts[i].left >= 0);
    CHECK(texts[i].right <= number(svg, "width", 0));
    CHECK(texts[i].bottom <= number(svg, "height", 0));
  }
}

}  // namespace

TEST_CASE("the picture of a clash shows all of its visits, however many", "[io]") {
  const std::size_t visits = GENERATE(1U, 2U, 3U, 7U, 8U, 12U, 15U, 40U);
  const Trace trace = long_trace(visits);
  const std::string svg = clash_svg(trace, clash_of_all(trace));
  INFO(visits);
  check_layout(svg);
  for (std::size_t k = 0; k < visits; ++k) {
    CHECK(count_of(svg, ">visit " + std::to_string(k) + "<") == (k == 0 ? 2U : 1U));
    CHECK(count_of(svg, ">" + std::to_string(k) + "<") == 1);
  }
  CHECK(count_of(svg, "<circle") == visits);
  CHECK(count_of(svg, travel_style) == visits - 1);
  for (const char* text : {">same(0, 3): impossible<", ">view<", ">what is claimed<",
                           ">visits 1 2 3 at places 0 1 2<", "\u00a73.2"})
    CHECK(svg.find(text) != std::string::npos);
}

TEST_CASE("each arm is drawn once, with a mouth or a bar, and an arrow where the robot went",
          "[io]") {
  Trace trace;
  trace.visits = {visit("v+1 h+0 v-1 h-1", {}, 2), visit("v+1 h+0 v-0 h-1", 3, {})};
  const std::string svg = clash_svg(trace, clash_of_all(trace));
  CHECK(count_of(svg, "stroke=\"#777777\" stroke-width=\"2.5\"") == 2 * 5);  // mouths
  CHECK(count_of(svg, "stroke=\"#777777\" stroke-width=\"5\"") == 8 + 3);    // arms, bars
  CHECK(count_of(svg, "Z\" fill=\"#222222\" stroke=\"#ffffff\"") == 2);      // arrows
  for (const char* name : {">v+<", ">h+<", ">v-<", ">h-<"}) CHECK(count_of(svg, name) == 2);
}

TEST_CASE("no travel passes through the disc of a visit", "[io]") {
  const Trace trace = long_trace(29);
  const std::string svg = clash_svg(trace, clash_of_all(trace));
  const auto points = corners(svg, travel_style);
  CHECK(points.size() > 2 * 28);
  // Outside of a square as wide as a star, lines along the axes stay outside of its disc; the ends
  // lie on the star's rim, 45 from the middle.
  for (const Box& disc : disc_boxes(svg))
    for (const auto& [x, y] : points)
      CHECK(std::hypot(x - (disc.left + disc.right) / 2, y - (disc.top + disc.bottom) / 2) > 44);
}

TEST_CASE("visits that the clash leaves out are a gap", "[io]") {
  const Trace trace = long_trace(12);
  ClashPicture clash = clash_of_all(trace);
  clash.visits = visits_of({2, 3, 7, 8, 11});
  const std::string svg = clash_svg(trace, clash);
  check_layout(svg);
  CHECK(count_of(svg, "\u2026") == 2);
  CHECK(count_of(svg, travel_style) == 2);
  CHECK(count_of(svg, "<circle") == 5);
}

TEST_CASE("claims join visits by red lines, within a row and from row to row", "[io]") {
  const Trace trace = long_trace(12);
  ClashPicture clash = clash_of_all(trace);
  clash.claimed = {{VisitId(0), VisitId(5), true},  {VisitId(0), VisitId(3), true},
                   {VisitId(2), VisitId(3), false}, {VisitId(3), VisitId(5), true},
                   {VisitId(1), VisitId(9), true},  {VisitId(2), VisitId(9), false},
                   {VisitId(11), VisitId(6), true}, {VisitId(7), VisitId(7), true}};
  const std::string svg = clash_svg(trace, clash);
  check_layout(svg);
  CHECK(count_of(svg, ">same place<") == 4);
  CHECK(count_of(svg, ">different places<") == 1);
  for (const char* half : {">same place as visit 9<", ">same place as visit 1<",
                           ">different places than visit 9<", ">different places than visit 2<"})
    CHECK(count_of(svg, half) == 1);
  CHECK(count_of(svg, "stroke-dasharray=\"6 4\"") == 3);
}

TEST_CASE("a claim of visits that take no part shows them dashed", "[io]") {
  const Trace trace = long_trace(12);
  ClashPicture clash = clash_of_all(trace);
  clash.visits = visits_of({2, 3});
  clash.claimed = {{VisitId(3), VisitId(4), true}};
  const std::string svg = clash_svg(trace, clash);
  check_layout(svg);
  CHECK(count_of(svg, "<circle") == 3);
  CHECK(count_of(svg, "stroke-dasharray=\"4 3\"") == 1);
  CHECK(count_of(svg, travel_style) == 1);  // the travel to a visit that is left out is none
}

TEST_CASE("a clash of no visits is words alone", "[io]") {
  const Trace trace = long_trace(2);
  ClashPicture clash;
  clash.title = "places < 1: impossible";
  clash.said = {{"places<1and" + std::string(200, 'x'), "what is claimed"}};
  const std::string svg = clash_svg(trace, clash);
  check_layout(svg);
  CHECK(count_of(svg, "<circle") == 0);
}

TEST_CASE("names in the picture of a clash are text, whatever is in them", "[io]") {
  const Trace trace = long_trace(2);
  ClashPicture clash = clash_of_all(trace);
  clash.title = "places < 3 & \"a\"";
  clash.said = {{"<b>", "</text>\x01"}};
  clash.without = {{"&", "<"}};
  const std::string svg = clash_svg(trace, clash);
  CHECK(is_well_formed(svg));
  for (const char* text : {">places &lt; 3 &amp; &quot;a&quot;<", ">&lt;b&gt;<", ">&lt;/text&gt;?<",
                           ">&amp;<", ">&lt;<"})
    CHECK(svg.find(text) != std::string::npos);
}

//  0 ---- 1      The square is driven round once, from 0 by 1, 2, 3 back to 0; place 2 has an arm
//  |      |      into the square, place 3 one out of it: the travel that joins them would cross a
//  3 ---- 2      side.
TEST_CASE(
    "the map that planarity forbids has its last travel in red, and what it crosses on a band",
    "[io]") {
  const auto place = [](const char* star, std::size_t visit) {
    return TopologicalMap::Place{Star::parse(star), VisitId(visit)};
  };
  const auto arm = [](std::size_t p, std::size_t a) { return PlaceArm{PlaceId(p), a}; };
  ClashPicture::Crossing crossing{{}, {}, VisitId(5)};
  crossing.map.places = {place("v+0 h+1 v-1 h-0", 0), place("v+0 h+0 v-1 h-1", 1),
                         place("v+1 h+0 v-0 h-1 d+1 d-0", 2), place("v+1 h+1 v-1 h-0", 3)};
  crossing.map.segments = {{arm(0, 1), arm(1, 3)},
                           {arm(0, 2), arm(3, 0)},
                           {arm(1, 2), arm(2, 0)},
                           {arm(2, 3), arm(3, 1)},
                           {arm(2, 4), arm(3, 2)}};
  crossing.drawing = draw(crossing.map);
  CHECK_FALSE(crossing.drawing.without_crossings);
  crossing.visits = {{VisitId(0), PlaceId(0)}, {VisitId(1), PlaceId(1)}, {VisitId(2), PlaceId(2)},
                     {VisitId(3), PlaceId(3)}, {VisitId(4), PlaceId(2)}, {VisitId(5), PlaceId(3)}};
  crossing.loops = {{PlaceId(0), PlaceId(1), PlaceId(2), PlaceId(3)}};
  const Trace trace = long_trace(6);
  ClashPicture clash = clash_of_all(trace);
  clash.crossing = crossing;
  const std::string svg = clash_svg(trace, clash);
  check_layout(svg);
  CHECK(count_of(svg, "stroke=\"#c00000\" stroke-width=\"5\"") == 1 + 1);   // and the legend's
  CHECK(count_of(svg, "stroke=\"#ffd9b3\" stroke-width=\"21\"") == 4 + 1);  // and the legend's
  for (const char* text : {">the travel to visit 5<", ">a closed way that it has to cross<",
                           ">place 0: visit 0<", ">place 2: visits 2, 4<"})
    CHECK(svg.find(text) != std::string::npos);
  CHECK(svg.rfind("#c00000\" stroke-width=\"5\"") > svg.rfind("#0072b2"));

  clash.crossing->names = {PlaceId(7), PlaceId(8), PlaceId(9), PlaceId(10)};
  const std::string renamed = clash_svg(trace, clash);
  for (const char* text : {">10</", ">place 7: visit 0<", ">place 9: visits 2, 4<"})
    CHECK(renamed.find(text) != std::string::npos);

  clash.crossing->loops.clear();
  CHECK(count_of(clash_svg(trace, clash), "#ffd9b3") == 0);
}

TEST_CASE("the same clash gives the same picture", "[io]") {
  const Trace trace = long_trace(12);
  const ClashPicture clash = clash_of_all(trace);
  CHECK(clash_svg(trace, clash) == clash_svg(trace, clash));
}
