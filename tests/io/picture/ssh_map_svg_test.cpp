#include "io/picture/ssh_map_svg.hpp"

#include "tests/io/picture/xml_check.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

//  0 ==== 1      out and back, the way back not known to be the same
SshMap two_segments() {
  const Action travel{Action::Kind::travel};
  const Action turn{Action::Kind::turn, "round"};
  const Experience seen{
      .name = "t", .views = {"a", "b", "c", "d", "a"}, .actions = {travel, turn, travel, turn}};
  return make_ssh_map(seen,
                      std::vector{DStateId(0), DStateId(1), DStateId(2), DStateId(3), DStateId(0)});
}

}  // namespace

TEST_CASE("the picture of a map of the basic SSH has every part of it", "[io][ssh]") {
  const SshMap map = two_segments();
  REQUIRE(map.segments.size() == 2);
  const std::string svg = ssh_map_svg(map, {{0, 0}, {1, 0}}, "<two> & \"one\"");
  CHECK(is_well_formed(svg));
  CHECK(count_of(svg, "<circle") == 2);
  CHECK(count_of(svg, "stroke=\"#222222\" stroke-width=\"5\"") == 1);  // the robot's ring
  // Side by side: a segment and a line of the legend for each of two paths.
  CHECK(count_of(svg, "#0072b2") == 2);
  CHECK(count_of(svg, "#e69f00") == 2);
  CHECK(count_of(svg, "Q91.0 ") == 2);
  for (const char* text : {"&lt;two&gt; &amp; &quot;one&quot;", "0: 0, 1", "place 0: views 0, 3, 4",
                           "place 1: views 1, 2"})
    CHECK(svg.find(text) != std::string::npos);
  CHECK(svg == ssh_map_svg(map, {{0, 0}, {1, 0}}, "<two> & \"one\""));
  CHECK_THROWS_AS(ssh_map_svg(map, {{0, 0}}, "t"), std::invalid_argument);
}
