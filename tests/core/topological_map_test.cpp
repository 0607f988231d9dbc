#include "core/topological_map.hpp"

#include "tests/support/catch.hpp"

using namespace asterism;

//  0 ---- 1      driven 0 1 3 2 0, clockwise round the square; each place is an L
//  |      |
//  2 ---- 3
namespace {
Trace square() {
  Trace trace;
  trace.visits = {
      {.star = Star::parse("v+0 h+1 v-1 h-0"), .entered_by = {}, .left_by = 1},
      {.star = Star::parse("v+0 h+0 v-1 h-1"), .entered_by = 3, .left_by = 2},
      {.star = Star::parse("v+1 h+0 v-0 h-1"), .entered_by = 0, .left_by = 3},
      {.star = Star::parse("v+1 h+1 v-0 h-0"), .entered_by = 1, .left_by = 0},
      {.star = Star::parse("v+0 h+1 v-1 h-0"), .entered_by = 2, .left_by = {}},
  };
  return trace;
}
Arrival at(std::size_t place, std::size_t arm) { return {PlaceId(place), arm}; }
}  // namespace

TEST_CASE("a closed square has four places, four segments and four paths", "[core]") {
  const Trace trace = square();
  const std::vector<Arrival> closed{{PlaceId(0), {}}, at(1, 3), at(2, 0), at(3, 1), at(0, 2)};
  const TopologicalMap map = make_map(trace, closed);
  CHECK(map.places.size() == 4);
  CHECK(map.segments.size() == 4);
  CHECK(map.paths.size() == 4);
  CHECK(arrivals(map) == closed);
  for (const auto& path : map.paths) {
    CHECK(path.places.size() == 2);
    REQUIRE(path.ends.size() == 2);
    CHECK(path.ends[0] < path.ends[1]);
    CHECK(path.ends[0].place == path.places.front());
    CHECK(path.ends[1].place == path.places.back());
  }
}

TEST_CASE("an open square has a fifth place", "[core]") {
  const TopologicalMap map = make_map(
      square(), std::vector<Arrival>{{PlaceId(0), {}}, at(1, 3), at(2, 0), at(3, 1), at(4, 2)});
  CHECK(map.places.size() == 5);
  CHECK(map.paths.size() == 6);  // 5 places * 2 - 4 segments
}

// Nothing licenses it, but it can be written: the travel out of place 1 comes in
// again by the gateway that it was first entered by.
TEST_CASE("a map whose gateways lead to two is written out all the same", "[core]") {
  Trace trace;
  trace.visits = {
      {.star = Star::parse("a+1 b+1 a-1 b-1"), .entered_by = {}, .left_by = 0},
      {.star = Star::parse("a-1 b+1 a+0 b-1"), .entered_by = 1, .left_by = 3},
      {.star = Star::parse("b-1 a-1 b+1 a+1"), .entered_by = 2, .left_by = {}},
  };
  const TopologicalMap map =
      make_map(trace, std::vector<Arrival>{{PlaceId(0), {}}, at(1, 1), at(1, 1)});
  CHECK(map.places.size() == 2);
  CHECK(map.segments.size() == 2);
  for (const auto& path : map.paths) CHECK((path.ends.empty() || path.ends.size() == 2));
}

TEST_CASE("places must be numbered by first visit", "[core]") {
  CHECK_THROWS_AS(make_map(square(), std::vector<Arrival>{{PlaceId(0), {}}, at(2, 3)}),
                  std::invalid_argument);
}

TEST_CASE("a trace walked backwards twice is the trace", "[core]") {
  const Trace trace = square();
  const Trace twice = reversed(reversed(trace));
  for (std::size_t k = 0; k < trace.visits.size(); ++k) {
    CHECK(twice.visits[k].star == trace.visits[k].star);
    CHECK(twice.visits[k].entered_by == trace.visits[k].entered_by);
    CHECK(twice.visits[k].left_by == trace.visits[k].left_by);
  }
}
