#include <algorithm>

#include "engine/minimal/minimal_search.hpp"
#include "tests/engine/minimal/small_trace.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

using Decision = SearchState::Decision;

std::size_t arms_of(const Trace& trace) {
  std::size_t arms = 0;
  for (const Visit& visit : trace.visits) arms += visit.star.size();
  return arms;
}

std::vector<Decision> random_decisions(std::size_t arms, std::size_t most, RandomEngine& engine) {
  const auto arm = [&] { return ArmId(below(arms, engine)); };
  std::vector<Decision> result(below(most + 1, engine), Decision{ArmId(0)});
  for (Decision& decision : result) {
    decision.arm = arm();
    if (chance(0.5, engine)) decision.same = arm();
  }
  return result;
}

/// One thing changed, or several.
SearchState damaged(SearchState state, std::size_t arms, RandomEngine& engine) {
  do switch (below(9, engine)) {
      case 0:
        state.limit = engine() >> below(64, engine);
        break;
      case 1:
        state.refused = engine() >> below(64, engine);
        break;
      case 2:
        state.is_level_begun = !state.is_level_begun;
        break;
      case 3:
        state.incumbent.reset();
        break;
      case 4:
        if (!state.models.empty()) state.models.back().resize(below(30, engine), ArmId(1));
        break;
      case 5:
        if (!state.models.empty() && !state.models.back().empty())
          state.models.back()[below(state.models.back().size(), engine)] =
              ArmId(below(arms + 5, engine));
        break;
      case 6:
        if (!state.models.empty()) state.incumbent = state.models.back();
        state.models.clear();
        break;
      case 7:
        if (!state.branches.empty()) state.branches.pop_back();
        break;
      default:
        state.branches.push_back({random_decisions(arms + (chance(0.1, engine) ? 3 : 0), 4, engine),
                                  random_decisions(arms, 4, engine)});
    }
  while (chance(0.5, engine));
  return state;
}

}  // namespace

TEST_CASE("a search goes on from no state that cannot be one, and ends with any other",
          "[engine][minimal][property]") {
  std::size_t refused = 0;
  std::size_t ended = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    const Trace trace = small_trace(seed, 300);
    INFO(to_keep(seed, trace));
    RandomEngine engine(seed);
    const bool planar = seed % 2 == 1;
    MinimalSearch stopped({.planar = planar});
    stopped.extend(trace.visits);
    stopped.run(stop_unless([&] { return !stopped.state().is_level_begun; }));
    const SearchState begun = stopped.state();
    stopped.run();
    const SearchState complete = stopped.state();
    for (int n = 0; n < 10; ++n) {
      MinimalSearch search(
          {.theory = {.planar = planar}, .jobs = 1 + static_cast<unsigned>(n % 2)});
      search.extend(trace.visits);
      try {
        search.resume(damaged(n % 2 == 0 ? begun : complete, arms_of(trace), engine));
        const auto outcome = search.run();
        REQUIRE(outcome == MinimalSearch::Outcome::complete);
      } catch (const std::invalid_argument&) {
        ++refused;
        continue;
      }
      for (const auto& model : search.models())
        CHECK(is_consistent(trace, model, {.planar = planar}));
      ++ended;
    }
  }
  CHECK(refused > 300);
  CHECK(ended > 300);
}

TEST_CASE("a state of another trace, or of none, is refused or searched", "[engine][minimal]") {
  const MinimalSearch other = searched(small_trace(3, 2'000), false);
  MinimalSearch none;
  CHECK_THROWS_AS(none.resume(other.state()), std::invalid_argument);
  MinimalSearch search;
  search.extend(small_trace(4, 2'000).visits);
  CHECK_THROWS_AS(search.resume(other.state()), std::invalid_argument);
  search.resume(SearchState{});
  CHECK(search.run() == MinimalSearch::Outcome::complete);
  CHECK(search.models() == searched(small_trace(4, 2'000), false).models());
}

TEST_CASE("what a search was resumed from is forgotten when the trace goes on",
          "[engine][minimal][property]") {
  for (unsigned seed = 0; seed < 100; ++seed) {
    const Trace trace = small_trace(seed, 300);
    INFO(to_keep(seed, trace));
    const std::size_t half = (trace.visits.size() + 1) / 2;
    const auto first = std::span(trace.visits).first(half);
    const MinimalSearch::Options options{
        .theory = {.planar = true,
                   .assumptions = {
                       {Assumption::Kind::same, VisitId(0), VisitId(trace.visits.size() / 2)}}}};
    MinimalSearch begun(options);
    begun.extend(first);
    begun.run(stop_unless([&] { return !begun.state().is_level_begun; }));
    MinimalSearch search(options);
    search.extend(first);
    search.resume(begun.state());
    search.extend(std::span(trace.visits).subspan(half));
    CHECK(search.run() == MinimalSearch::Outcome::complete);
    CHECK(search.models() == searched(trace, options).models());
  }
}
