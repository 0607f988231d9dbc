#include <algorithm>

#include "engine/minimal/minimal_search.hpp"
#include "tests/engine/minimal/small_trace.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

using Outcome = MinimalSearch::Outcome;

/// What a search says is known, against what is true.
void check_sound(const MinimalSearch& search, const MinimalSearch& complete) {
  const MinimalSearch::Bounds so_far = search.bounds();
  const MinimalSearch::Bounds truth = complete.bounds();
  REQUIRE(truth.best);
  CHECK(so_far.at_least <= truth.best->paths);
  CHECK(so_far.best.has_value() == (so_far.count > 0));
  if (!so_far.best) return;
  CHECK(std::pair(so_far.best->paths, so_far.best->places) >=
        std::pair(truth.best->paths, truth.best->places));
  const Models models = search.models();
  CHECK(models.size() == so_far.count);
  const auto found = std::span(models).first(std::min<std::size_t>(models.size(), 3));
  for (const auto& model : found) {
    CHECK(is_consistent(search.trace(), model, {.planar = search.options().theory.planar}));
    const Extents extents = extents_of(make_map(search.trace(), model));
    CHECK(extents.paths == so_far.best->paths);
    CHECK(extents.places == so_far.best->places);
  }
}

/// Searches until asked for the n-th time.
Outcome run_until(MinimalSearch& search, std::size_t n) {
  return search.run(stop_unless([&] { return n-- > 0; }));
}

/// Searches to the end, in a fresh search after each stop: while the trace is folded, or later.
Models in_pieces(const MinimalSearch& complete, unsigned first_jobs, RandomEngine& engine,
                 std::size_t& stops) {
  MinimalSearch::Options options = complete.options();
  options.jobs = first_jobs;
  SearchState state;
  while (true) {
    MinimalSearch search(options);
    search.extend(complete.trace().visits);
    search.resume(state);
    const bool stops_early = chance(0.2, engine);
    std::size_t n = below(3, engine);
    const Stop stop =
        stop_unless([&] { return (!stops_early && search.branchings() == 0) || n-- > 0; });
    if (search.run(stop) == Outcome::complete) return search.models();
    ++stops;
    check_sound(search, complete);
    state = search.state();
    options.jobs = 1 + static_cast<unsigned>(below(4, engine));
  }
}

/// Lists every star from another arm, with labels of its own.
Trace relisted(Trace trace, RandomEngine& engine) {
  for (Visit& visit : trace.visits) {
    const std::size_t size = visit.star.size();
    const std::size_t first = below(size, engine);
    std::vector<Arm> arms;
    for (std::size_t i = 0; i < size; ++i) {
      arms.push_back(visit.star.arm((first + i) % size));
      arms.back().label = "other_" + arms.back().label;
      arms.back().sign = arms.back().sign == '+' ? '-' : '+';
    }
    visit.star = Star(arms);
    for (auto* arm : {&visit.entered_by, &visit.left_by})
      if (*arm) **arm = (**arm + size - first) % size;
  }
  return trace;
}

std::vector<std::vector<PlaceId>> places_visited(const Models& models) {
  std::vector<std::vector<PlaceId>> result;
  for (const auto& model : models) {
    result.emplace_back();
    for (const Arrival& arrival : model) result.back().push_back(arrival.place);
  }
  std::ranges::sort(result);
  return result;
}

/// ... with threads, also when stopped now and then, and resumed with another number of them.
void compare_threads(unsigned seed, bool planar, std::size_t& stops) {
  const Trace trace = long_trace(seed, 6, 100);
  INFO(to_keep(seed, trace));
  const MinimalSearch one = searched(trace, planar);
  CHECK(one.branchings() > 3'000);
  RandomEngine engine(seed);
  for (const unsigned jobs : {2U, 4U}) {
    const MinimalSearch several = searched(trace, {.theory = {.planar = planar}, .jobs = jobs});
    CHECK(several.models() == one.models());
    CHECK(several.bounds().at_least == one.bounds().at_least);
    CHECK(in_pieces(one, jobs, engine, stops) == one.models());
  }
}

}  // namespace

TEST_CASE("visit by visit the search finds what it finds at once", "[engine][minimal][property]") {
  for (unsigned seed = 0; seed < 100; ++seed) {
    const Trace trace = small_trace(seed, 2'000);
    INFO(to_keep(seed, trace));
    RandomEngine engine(seed);
    for (const bool planar : {false, true}) {
      MinimalSearch one_by_one({.planar = planar});
      MinimalSearch stopped({.planar = planar});
      Trace so_far;
      for (Visit visit : trace.visits) {
        so_far.visits.push_back(visit);
        const auto left_by = std::exchange(visit.left_by, std::nullopt);
        one_by_one.extend(visit);
        CHECK_FALSE(one_by_one.is_complete());
        REQUIRE(one_by_one.run() == Outcome::complete);
        const MinimalSearch complete = searched(so_far, planar);
        CHECK(one_by_one.models() == complete.models());
        CHECK(one_by_one.bounds().at_least == complete.bounds().at_least);
        check_sound(one_by_one, complete);
        stopped.extend(visit);
        run_until(stopped, below(so_far.visits.size() + 2, engine));
        check_sound(stopped, complete);
        if (left_by) one_by_one.leave(*left_by);
        if (left_by) stopped.leave(*left_by);
      }
      REQUIRE(stopped.run() == Outcome::complete);
      CHECK(stopped.models() == one_by_one.models());
    }
  }
}

TEST_CASE("a search extended by several visits goes on from what it knew",
          "[engine][minimal][assumption][property]") {
  for (unsigned seed = 0; seed < 400; ++seed) {
    const Trace trace = small_trace(seed, 2'000);
    INFO(to_keep(seed, trace));
    RandomEngine engine(seed);
    MinimalSearch::Options options{.theory = {.planar = seed % 2 == 0}};
    if (seed % 3 == 0)
      options.theory.assumptions.push_back(
          {Assumption::Kind::differ, VisitId(0), VisitId(1 + below(trace.visits.size(), engine))});
    MinimalSearch search(options);
    for (std::size_t from = 0; from < trace.visits.size();) {
      const std::size_t count = 1 + below(trace.visits.size() - from, engine);
      search.extend(std::span(trace.visits).subspan(from, count));
      from += count;
      run_until(search, below(2 * from, engine));
    }
    // A search of the same trace that grew otherwise.
    MinimalSearch resumed(options);
    resumed.extend(trace.visits);
    resumed.resume(search.state());
    CHECK(resumed.run() == Outcome::complete);
    REQUIRE(search.run() == Outcome::complete);
    const Models models = searched(trace, options).models();
    CHECK(search.models() == models);
    CHECK(resumed.models() == models);
  }
}

TEST_CASE("stopped and resumed at any moment, the search finds the same",
          "[engine][minimal][property]") {
  std::size_t stops = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Trace trace = small_trace(seed, 2'000);
    INFO(to_keep(seed, trace));
    RandomEngine engine(seed);
    const MinimalSearch complete = searched(trace, seed % 2 == 0);
    CHECK(in_pieces(complete, 1 + seed % 3, engine, stops) == complete.models());
    MinimalSearch again(complete.options());
    again.extend(trace.visits);
    again.resume(complete.state());
    CHECK(again.run() == Outcome::complete);
    CHECK(again.models() == complete.models());
  }
  CHECK(stops > 100);
}

TEST_CASE("a search without any map can be stopped and resumed", "[engine][minimal][assumption]") {
  std::size_t none = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Trace trace = small_trace(seed, 500);
    INFO(to_keep(seed, trace));
    RandomEngine engine(seed);
    const auto visit = [&] { return VisitId(below(trace.visits.size(), engine)); };
    MinimalSearch::Options options{.theory = {.planar = true}};
    for (int n = 0; n < 3; ++n) {
      const VisitId one = visit();
      options.theory.assumptions.push_back({Assumption::Kind::same, one, visit()});
    }
    const Models models = searched(trace, options).models();
    if (!models.empty()) continue;
    ++none;
    MinimalSearch search(options);
    search.extend(trace.visits);
    for (std::size_t n = 0; run_until(search, n) == Outcome::stopped; ++n) {
      const SearchState state = search.state();
      search = MinimalSearch(options);
      search.extend(trace.visits);
      search.resume(state);
    }
    CHECK(search.is_complete());
    CHECK(search.models().empty());
    CHECK_FALSE(search.bounds().best);
  }
  CHECK(none > 30);
}

TEST_CASE("any number of threads finds the same", "[engine][minimal][threads]") {
  std::size_t stops = 0;
  compare_threads(4, false, stops);
  compare_threads(5, false, stops);
  compare_threads(5, true, stops);
  CHECK(stops > 5);
}

TEST_CASE("any number of threads finds the same in long searches",
          "[engine][minimal][threads][full]") {
  std::size_t stops = 0;
  compare_threads(10, false, stops);
  compare_threads(13, true, stops);
  compare_threads(6, true, stops);
  CHECK(stops > 5);
}

TEST_CASE("a trace walked backwards has as many minimal models, of the same size",
          "[engine][minimal][property]") {
  for (unsigned seed = 0; seed < 400; ++seed) {
    const Trace trace = small_trace(seed, 2'000);
    INFO(to_keep(seed, trace));
    for (const bool planar : {false, true}) {
      const auto there = searched(trace, planar).bounds();
      const auto back = searched(reversed(trace), planar).bounds();
      CHECK(there.count == back.count);
      CHECK(there.best->paths == back.best->paths);
      CHECK(there.best->places == back.best->places);
    }
  }
}

TEST_CASE("labels, signs and the arm listed first change no minimal model",
          "[engine][minimal][property]") {
  for (unsigned seed = 0; seed < 400; ++seed) {
    const Trace trace = small_trace(seed, 2'000);
    INFO(to_keep(seed, trace));
    RandomEngine engine(seed);
    const Trace other = relisted(trace, engine);
    for (const bool planar : {false, true})
      CHECK(places_visited(searched(other, planar).models()) ==
            places_visited(searched(trace, planar).models()));
  }
}
