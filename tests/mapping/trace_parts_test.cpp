#include "mapping/trace_parts.hpp"

#include <algorithm>
#include <tuple>

#include "core/random.hpp"
#include "engine/tree/map_tree.hpp"
#include "simulation/grid_world.hpp"
#include "simulation/walk.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

using Cuts = std::vector<std::size_t>;

/// Of all ways to cut into explained parts, the one wanted, by trial of each.
Cuts by_trial(std::size_t visits, const std::vector<std::size_t>& until) {
  std::optional<std::tuple<std::size_t, std::size_t, Cuts>> best;  // cuts, -squares, -where
  for (std::size_t set = 0; set < std::size_t{1} << (visits - 1); ++set) {
    Cuts cuts, after;
    std::size_t squares = 0, first = 0;
    bool is_explained = true;
    for (std::size_t k = 1; k <= visits; ++k) {
      if (k < visits && !(set >> (k - 1) & 1)) continue;
      is_explained &= k <= until[first];
      squares += (k - first) * (k - first);
      if (k < visits) cuts.push_back(k), after.push_back(visits - k);
      first = k;
    }
    if (!is_explained) continue;
    const auto here = std::tuple(cuts.size(), visits * visits - squares, after);
    if (!best || here < *best) best = here;
  }
  Cuts result = std::get<2>(*best);
  for (std::size_t& cut : result) cut = visits - cut;
  return result;
}

/// A walk through two buildings as if they were one.
Trace two_walks(RandomEngine& random) {
  Trace trace;
  for (int i = 0; i < 2; ++i) {
    const World world = grid_world({.width = 3, .height = 2}, random);
    const Trace part = walk(world, {.travels = 2 + random() % 5}, random).trace;
    if (!trace.visits.empty()) {
      Visit& last = trace.visits.back();
      if (!last.left_by) last.left_by = last.entered_by;
    }
    trace.visits.insert(trace.visits.end(), part.visits.begin(), part.visits.end());
    Visit& first = trace.visits[trace.visits.size() - part.visits.size()];
    if (!first.entered_by) first.entered_by = first.left_by;
  }
  return trace;
}

}  // namespace

TEST_CASE("a trace is cut as all ways to cut it say", "[mapping][property]") {
  RandomEngine random(1);
  for (int round = 0; round < 2000; ++round) {
    const std::size_t visits = 1 + random() % 10;
    std::vector<std::size_t> until(visits);
    std::size_t least = 0;
    for (std::size_t k = 0; k < visits; ++k)
      until[k] = least = std::min(visits, std::max({least, k + 1, k + random() % 5}));
    const auto cuts = fewest_cuts(visits, [&](std::size_t first) { return until[first]; });
    REQUIRE(cuts);
    CHECK(*cuts == by_trial(visits, until));
  }
}

TEST_CASE("where it is not to be known what is explained, nothing is cut", "[mapping][unit]") {
  CHECK_FALSE(fewest_cuts(5, [](std::size_t first) {
    return first < 2 ? std::optional<std::size_t>(first + 1) : std::nullopt;
  }));
  CHECK_FALSE(fewest_cuts(5, [](std::size_t first) { return std::optional(first); }));
}

TEST_CASE("the search and the tree cut traces at the same visits", "[mapping][property]") {
  RandomEngine random(7);
  int cut = 0;
  for (int round = 0; round < 60; ++round) {
    const Trace trace = two_walks(random);
    const std::size_t visits = trace.visits.size();
    std::vector<std::size_t> until;
    for (std::size_t first = 0; first < visits; ++first) {
      MapTree tree;
      tree.extend(part_of(trace, first, visits).visits);
      const auto counts = tree.per_visit();
      until.push_back(first + static_cast<std::size_t>(std::ranges::find(counts, std::uint64_t{0}) -
                                                       counts.begin()));
    }
    const auto cuts = cuts_of(trace, {}, {});
    REQUIRE(cuts);
    CHECK(*cuts == fewest_cuts(visits, [&](std::size_t first) { return until[first]; }));
    cut += !cuts->empty();
  }
  CHECK(cut > 10);
}

TEST_CASE("what is assumed of two visits of a part is asked of it, by its own numbers",
          "[mapping][unit]") {
  const Theory theory{.planar = true,
                      .assumptions = {{Assumption::Kind::same, VisitId(1), VisitId(4)},
                                      {Assumption::Kind::differ, VisitId(3), VisitId(2)}}};
  const Theory part = theory_of_part(theory, 2, 5);
  CHECK(part.planar);
  CHECK(text_of(part.assumptions) == "differ(1, 0)");
}
