#include "engine/proof/crossing_map.hpp"

#include <algorithm>
#include <span>

#include "drawing/plane_drawing.hpp"
#include "planarity/euler.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

PartialMap partial(const Association& association) {
  return {association.begin(), association.end()};
}

/// Without the segment of the travel, which is the last.
TopologicalMap before(TopologicalMap map) {
  map.segments.pop_back();
  return map;
}

}  // namespace

TEST_CASE("a map that cannot be drawn is shown up to the first travel that crosses",
          "[engine][property]") {
  std::size_t crossings = 0;
  for (unsigned seed = 0; seed < 150; ++seed) {
    const Trace trace = seeded_walk(seed, 9).trace;
    for (const Association& association : maps_of(tree_of(trace, false))) {
      const auto crossing = find_crossing(trace, partial(association));
      const TopologicalMap whole = make_map(trace, association);
      INFO(to_keep(seed, trace));
      REQUIRE(crossing.has_value() == !is_planar(whole));
      if (!crossing) continue;
      ++crossings;
      const CrossingMap shown = crossing_map(trace, partial(association), *crossing);
      // It is all that make_map knows of the visits up to there: nothing is in another piece.
      const TopologicalMap known =
          make_map(trace, std::span(association).first(crossing->visit.index() + 1));
      std::vector<TopologicalMap::Segment> segments = shown.map.segments;
      CHECK(segments.back() ==
            TopologicalMap::Segment(std::minmax(crossing->left, crossing->entered)));
      std::ranges::sort(segments);
      CHECK(segments == known.segments);
      CHECK(shown.map.places.size() == known.places.size());
      CHECK(shown.visits.size() == crossing->visit.index() + 1);
      CHECK_FALSE(is_planar(shown.map));
      CHECK(is_planar(before(shown.map)));
      CHECK(draw(before(shown.map)).without_crossings);
      CHECK_FALSE(draw(shown.map).without_crossings);
    }
  }
  CHECK(crossings > 50);
}

TEST_CASE("places of another piece are not shown, and the others keep their names", "[engine]") {
  // A walk that cannot be drawn as explained, after one of two visits that nothing leads on from.
  for (unsigned seed = 0;; ++seed) {
    REQUIRE(seed < 500);
    const Trace walk = seeded_walk(seed, 9).trace;
    for (const Association& association : maps_of(tree_of(walk, false))) {
      const auto alone = find_crossing(walk, partial(association));
      if (!alone) continue;
      Trace trace{.name = "pieces", .visits = {}};
      trace.visits = {{.star = Star::parse("a+1 a-0"), .left_by = 0},
                      {.star = Star::parse("b+1 b-1"), .entered_by = 0, .left_by = 1},
                      {.star = Star::parse("b+1 b-1"), .entered_by = 0, .left_by = 1}};
      trace.visits.insert(trace.visits.end(), walk.visits.begin(), walk.visits.end());
      PartialMap map{Arrival{PlaceId(0), {}}, Arrival{PlaceId(1), 0}, std::nullopt};
      for (const Arrival& arrival : association)
        map.emplace_back(Arrival{PlaceId(arrival.place.index() + 2), arrival.entered});
      const auto crossing = find_crossing(trace, map);
      REQUIRE(crossing);
      const CrossingMap shown = crossing_map(trace, map, *crossing);
      const CrossingMap expected = crossing_map(walk, partial(association), *alone);
      CHECK(shown.map.segments == expected.map.segments);
      CHECK(shown.loops == expected.loops);
      CHECK(shown.visits.size() == expected.visits.size());
      CHECK(shown.visits.front().first == VisitId(3));
      CHECK(shown.names.front() == PlaceId(2));
      return;
    }
  }
}
