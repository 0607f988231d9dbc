#include "engine/ask/query_map.hpp"

#include <algorithm>

#include "engine/ask/query.hpp"
#include "engine/ask/query_reader.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/support/axiom_files.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

/// Whether the view says what the map written out does, paths and all.
bool agree(QueryMap& view, const TopologicalMap& map) {
  bool agrees = view.places() == map.places.size() && view.segments() == map.segments.size() &&
                view.paths() == map.paths.size();
  for (std::size_t path = 0; agrees && path < map.paths.size(); ++path)
    agrees = std::ranges::equal(view.places_of(PathId(path)), map.paths[path].places) &&
             view.is_closed(PathId(path)) == map.paths[path].ends.empty();
  return agrees;
}

/// Any data association at all, numbered by first visit.
Association random_association(const Trace& trace, RandomEngine& engine) {
  Association result;
  std::vector<std::size_t> arms;  ///< of each place
  for (const Visit& visit : trace.visits) {
    const std::size_t place = below(arms.size() + 1, engine);
    const bool is_new = place == arms.size();
    if (is_new) arms.push_back(visit.star.size());
    result.push_back({PlaceId(place), is_new ? visit.entered_by : below(arms[place], engine)});
  }
  return result;
}

bool holds_in(const Trace& trace, const Association& map, const std::string& text) {
  QueryMap view(trace);
  view.set(map);
  return holds(read_query(text).claim, view);
}

}  // namespace

TEST_CASE("queries see what the map written out says, whatever is one place",
          "[engine][query][property]") {
  RandomEngine engine(7);
  std::size_t closed = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Trace trace = seeded_walk(seed, 4 + seed % 9).trace;
    QueryMap view(trace);
    for (int i = 0; i < 20; ++i) {
      const Association association = random_association(trace, engine);
      const TopologicalMap map = make_map(trace, association);
      view.set(association);
      INFO(to_keep(seed, trace));
      CHECK(agree(view, map));
      closed += std::ranges::any_of(map.paths, [](const auto& path) { return path.ends.empty(); });
    }
  }
  CHECK(closed > 100);
}

TEST_CASE("queries see what the map written out says where a path may meet a place twice",
          "[engine][query]") {
  const AxiomSet own = AxiomSet::parse(with_axiom(shipped_files(), "irreflexive"));
  std::size_t more = 0;
  for (const unsigned seed : {2U, 3U, 8U, 9U}) {
    const Trace trace = seeded_walk(seed, 10).trace;
    const MapTree tree = tree_of(trace, {.theory = {.axioms = own}, .check = Check::solver});
    QueryMap view(trace);
    tree.for_each([&](HypothesisId, std::span<const Arrival> arrivals) {
      view.set(arrivals);
      CHECK(agree(view, make_map(trace, arrivals)));
    });
    more += tree.size() - tree_of(trace, false).size();
  }
  CHECK(more > 5);
}

//   0 --- 1 --- 2 --- (0)     three crossings on a path that closes on itself
TEST_CASE("along a path that closes on itself all places come again and again", "[engine][query]") {
  const Star crossing = Star::parse("a+1 b+1 a-1 b-1");
  Trace trace{.name = "ring", .visits = {}};
  for (int k = 0; k < 4; ++k)
    trace.visits.push_back({.star = crossing, .entered_by = 2, .left_by = 0});
  trace.visits.back().left_by.reset();
  const auto at = [](std::size_t place) { return Arrival{PlaceId(place), 2}; };
  const Association ring{at(0), at(1), at(2), at(0)};
  CHECK(holds_in(trace, ring, "order(0, 2, 1) and order(1, 0, 2) and order(1, 1, 1)"));
  CHECK(holds_in(trace, ring, "paths = 4 and segments = 3 and steps(0, 2) = 1"));
  const Association line{at(0), at(1), at(2), at(3)};
  CHECK(holds_in(trace, line, "order(0, 1, 3) and order(3, 2, 0) and steps(0, 3) = 3"));
  CHECK(!holds_in(trace, line, "order(0, 2, 1) or order(1, 1, 1) or order(0, 0, 1)"));
}
