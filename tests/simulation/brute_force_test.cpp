#include "tests/support/brute_force.hpp"

#include <algorithm>

#include "simulation/corridor_world.hpp"
#include "simulation/grid_world.hpp"
#include "simulation/walk.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/known_traces.hpp"

using namespace asterism;

namespace {

using Cost = std::pair<std::size_t, std::size_t>;  ///< paths, then places

Cost cost(const Trace& trace, const Association& association) {
  const TopologicalMap map = make_map(trace, association);
  return {map.paths.size(), map.places.size()};
}

std::vector<std::size_t> visits(const Association& association) {
  std::vector<std::size_t> result;
  for (const Arrival& arrival : association) result.push_back(arrival.place.index());
  return result;
}

void check_counts(const KnownTrace& known, const KnownCounts& counts,
                  const BruteForceOptions& options) {
  const auto levels = every_map_by_visit(known.trace, options);
  std::vector<std::size_t> per_visit;
  for (const auto& level : levels) per_visit.push_back(level.size());
  CHECK(per_visit == counts.per_visit);
  CHECK(levels.back().size() == counts.consistent);

  Cost least = cost(known.trace, levels.back().front());
  for (const auto& map : levels.back()) least = std::min(least, cost(known.trace, map));
  CHECK(least == Cost(counts.minimal_paths, counts.minimal_places));
  std::vector<std::vector<std::size_t>> minimal;
  for (const auto& map : levels.back())
    if (cost(known.trace, map) == least) minimal.push_back(visits(map));
  std::sort(minimal.begin(), minimal.end());
  CHECK(minimal == counts.minimal_visits);
}

std::size_t count(const Trace& trace, const BruteForceOptions& options) {
  return every_map_by_visit(trace, options).back().size();
}

}  // namespace

TEST_CASE("brute force finds the known maps of the known traces", "[simulation][reference]") {
  const auto known = GENERATE(from_range(known_traces()));
  INFO(known.trace.name);
  check_counts(known, known.all, {});
  check_counts(known, known.planar, {.planar = true});
  const auto planar = every_map_by_visit(known.trace, {.planar = true}).back();
  CHECK(std::any_of(planar.begin(), planar.end(),
                    [&](const auto& map) { return visits(map) == known.true_visits; }));
}

TEST_CASE("optional axioms drop the known number of maps", "[simulation][reference]") {
  const auto all = known_traces();
  const auto eight = std::find_if(all.begin(), all.end(), [](const KnownTrace& known) {
    return known.trace.name == "eight-crossings";
  });
  REQUIRE(eight != all.end());
  CHECK(count(eight->trace, {.one_segment = true}) == 77);
  CHECK(count(eight->trace, {.planar = true, .one_segment = true}) == 45);
  CHECK(count(eight->trace, {.one_crossing = true}) == 74);
  CHECK(count(eight->trace, {.planar = true, .one_crossing = true}) == 45);
}

TEST_CASE("visit by visit brute force finds what it finds at the end alone",
          "[simulation][reference][property]") {
  const auto seed = GENERATE(range(0U, 60U));
  const bool planar = GENERATE(false, true);
  RandomEngine engine(seed);
  const World world = seed % 2 == 0 ? grid_world({.width = 3, .height = 3}, engine)
                                    : corridor_world({.corridors = 5}, engine);
  const Trace trace = walk(world, {.travels = 4}, engine).trace;
  CHECK(every_map(trace, {.planar = planar}) ==
        every_map_by_visit(trace, {.planar = planar}).back());
}

TEST_CASE("how the first visit was entered says nothing about the map", "[simulation][reference]") {
  auto known = GENERATE(from_range(known_traces()));
  for (std::size_t arm = 0; arm < known.trace.visits.front().star.size(); ++arm) {
    if (!known.trace.visits.front().star.has_gateway(arm)) continue;
    known.trace.visits.front().entered_by = arm;
    CHECK(count(known.trace, {}) == known.all.consistent);
  }
}
