#include "engine/minimal/minimal_search.hpp"

#include <algorithm>

#include "engine/minimal/minimal_models.hpp"
#include "tests/engine/minimal/small_trace.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

using Kind = Assumption::Kind;
using Order = std::vector<std::string>;

/// What the worlds of a test held, so that none passes by being trivial.
struct Tally {
  std::size_t several_models = 0;
  std::size_t many_maps = 0;
  std::size_t closures = 0;  ///< minimal models that come to a place by a new segment
  std::size_t no_maps = 0;
  std::size_t planar_differs = 0;
  std::uint64_t maps = 0;
};

/// The search against the tree of all maps.
Models compare(const Trace& trace, MapTree::Options options, Tally& tally) {
  const MinimalSearch search = searched(trace, {.theory = options.theory});
  const MapTree tree = tree_of(trace, std::move(options));
  const Models listed = minimal_models(tree);
  const Models found = search.models();
  CHECK(found == listed);
  CHECK(search.is_complete());
  const MinimalSearch::Bounds bounds = search.bounds();
  CHECK(bounds.count == listed.size());
  CHECK(bounds.best.has_value() == !listed.empty());
  tally.maps += tree.size();
  if (listed.empty()) {
    ++tally.no_maps;
    return listed;
  }
  const TopologicalMap map = make_map(trace, listed.front());
  const Extents least = extents_of(map);
  REQUIRE(bounds.best);
  CHECK(bounds.best->paths == least.paths);
  CHECK(bounds.best->places == least.places);
  CHECK(bounds.best->segments == least.segments);  // of the first, minimised or not
  CHECK(bounds.at_least == least.of(tree.options().theory.axioms.preference().front()));
  if (listed.size() > 1) ++tally.several_models;
  if (tree.size() > 100) ++tally.many_maps;
  if (map.segments.size() >= map.places.size()) ++tally.closures;
  return listed;
}

void compare_all(unsigned begin, unsigned end, std::uint64_t most_maps, Tally& tally) {
  for (unsigned seed = begin; seed < end; ++seed) {
    const Trace trace = small_trace(seed, most_maps);
    INFO(to_keep(seed, trace));
    Models models[2];
    for (const bool planar : {false, true})
      models[planar] =
          compare(trace, {.theory = {.axioms = shipped_with(), .planar = planar}}, tally);
    if (models[false] != models[true]) ++tally.planar_differs;
  }
}

Trace only_of(std::initializer_list<const char*> stars) {
  Trace trace;
  for (const char* star : stars) trace.visits.push_back({.star = Star::parse(star)});
  return trace;
}

}  // namespace

TEST_CASE("the search finds the minimal models that the tree lists",
          "[engine][minimal][property]") {
  Tally tally;
  compare_all(0, 2000, 4'000, tally);
  CHECK(tally.several_models > 500);
  CHECK(tally.many_maps > 500);
  CHECK(tally.closures > 500);
  CHECK(tally.planar_differs > 100);
  CHECK(tally.maps > 500'000);
  CHECK(tally.no_maps == 0);
}

TEST_CASE("the search finds the minimal models of many more and larger worlds",
          "[engine][minimal][property][full]") {
  Tally tally;
  compare_all(2000, 12'000, 20'000, tally);
  compare_all(12'000, 12'300, 1'000'000, tally);
}

TEST_CASE("the search minimises whatever extents, in any order",
          "[engine][minimal][preference][property]") {
  const auto order = GENERATE(values<Order>({{"path"},
                                             {"place"},
                                             {"segment"},
                                             {"path", "place"},
                                             {"place", "path"},
                                             {"path", "segment"},
                                             {"segment", "path"},
                                             {"place", "segment"},
                                             {"segment", "place"},
                                             {"path", "place", "segment"},
                                             {"path", "segment", "place"},
                                             {"place", "path", "segment"},
                                             {"place", "segment", "path"},
                                             {"segment", "path", "place"},
                                             {"segment", "place", "path"}}));
  const AxiomSet axioms = preferring(order);
  REQUIRE(axioms.preference_names() == order);
  Tally tally;
  for (unsigned seed = 0; seed < 80; ++seed) {
    const Trace trace = small_trace(seed, 1'000);
    INFO(to_keep(seed, trace));
    compare(trace, {.theory = {.axioms = axioms, .planar = seed / 7 % 2 == 1}}, tally);
  }
  CHECK(tally.several_models > 10);
}

TEST_CASE("the search keeps the optional axioms", "[engine][minimal][property]") {
  const std::string axiom = GENERATE("one_segment", "one_crossing");
  std::size_t differ = 0;
  Tally tally;
  for (unsigned seed = 0; seed < 400; ++seed) {
    const Trace trace = small_trace(seed, 2'000);
    INFO(to_keep(seed, trace));
    for (const bool planar : {false, true}) {
      const Models with =
          compare(trace, {.theory = {.axioms = shipped_with(axiom), .planar = planar}}, tally);
      if (with != searched(trace, planar).models()) ++differ;
    }
  }
  CHECK(differ > 10);
}

TEST_CASE("the search holds what is assumed", "[engine][minimal][assumption][property]") {
  Tally tally;
  for (unsigned seed = 0; seed < 600; ++seed) {
    const Trace trace = small_trace(seed, 1'000);
    RandomEngine engine(seed);
    std::vector<Assumption> assumptions;
    for (std::size_t n = 1 + below(3, engine); n > 0; --n) {
      // Some name visits to come, some one visit twice, some contradict others.
      const std::size_t visits = trace.visits.size() + (seed % 4 == 0 ? 2 : 0);
      assumptions.push_back({chance(0.4, engine) ? Kind::same : Kind::differ,
                             VisitId(below(visits, engine)), VisitId(below(visits, engine))});
    }
    INFO(to_keep(seed, trace) << text_of(assumptions));
    for (const bool planar : {false, true})
      compare(trace,
              {.theory = {.axioms = shipped_with(), .planar = planar, .assumptions = assumptions}},
              tally);
  }
  CHECK(tally.no_maps > 100);
  CHECK(tally.no_maps < 900);
  CHECK(tally.several_models > 50);
}

TEST_CASE("a search for the maps of a trace that has none ends", "[engine][minimal][assumption]") {
  const Trace trace = small_trace(4, 1'000);
  const auto assume = [](Kind kind, std::size_t one, std::size_t other) {
    return Assumption{kind, VisitId(one), VisitId(other)};
  };
  const std::vector<std::vector<Assumption>> contradictory = {
      {assume(Kind::differ, 2, 2)},
      {assume(Kind::same, 0, 3), assume(Kind::differ, 3, 0)},
      {assume(Kind::same, 0, 1)},  // of two places in a row
      {assume(Kind::same, 1, 2), assume(Kind::differ, 90, 91)}};
  for (const auto& assumptions : contradictory) {
    INFO(text_of(assumptions));
    MinimalSearch search({.assumptions = assumptions});
    for (std::size_t k = 0; k < trace.visits.size(); ++k) {
      search.extend(trace.visits[k]);
      CHECK(search.run() == MinimalSearch::Outcome::complete);
    }
    CHECK(search.models().empty());
    CHECK_FALSE(search.bounds().best);
  }
  // These say nothing.
  CHECK(searched(trace, {.theory = {.assumptions = {assume(Kind::same, 2, 2),
                                                    assume(Kind::differ, 0, 99)}}})
            .models() == searched(trace, false).models());
}

TEST_CASE("maps of no visit and of one", "[engine][minimal]") {
  MinimalSearch none;
  CHECK(none.run() == MinimalSearch::Outcome::complete);
  CHECK(none.bounds().at_least == 0);
  CHECK_THROWS_AS(none.leave(0), std::invalid_argument);
  for (const Order& order : {Order{"path", "place"}, Order{"segment"}, Order{"place"}}) {
    MinimalSearch one({.axioms = preferring(order)});
    one.extend(only_of({"a+1 b+1 a-1 b-0"}).visits);
    CHECK(one.run() == MinimalSearch::Outcome::complete);
    CHECK(one.models().size() == 1);
    CHECK_THROWS_AS(one.extend(only_of({"a+1 a-0"}).visits), std::invalid_argument);
    CHECK(one.models().size() == 1);  // as before
    CHECK_THROWS_AS(one.leave(3), std::invalid_argument);
  }
}

TEST_CASE("the search finds the least of the maps that brute force finds",
          "[engine][minimal][reference][property]") {
  std::size_t several = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Trace trace = small_trace(seed, 40);
    INFO(to_keep(seed, trace));
    for (const bool planar : {false, true}) {
      const auto size = [&](const Association& association) {
        const TopologicalMap map = make_map(trace, association);
        return std::pair(map.paths.size(), map.places.size());
      };
      auto maps = every_map_by_visit(trace, {.planar = planar}).back();
      const auto least = size(*std::ranges::min_element(maps, {}, size));
      std::erase_if(maps, [&](const Association& map) { return size(map) != least; });
      std::ranges::sort(maps, is_before);
      CHECK(searched(trace, planar).models() == maps);
      if (maps.size() > 1) ++several;
    }
  }
  CHECK(several > 5);
}
