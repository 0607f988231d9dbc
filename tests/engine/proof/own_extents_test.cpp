#include <algorithm>
#include <set>

#include "axioms/least_closure.hpp"
#include "engine/ask/map_list.hpp"
#include "engine/ask/query.hpp"
#include "engine/facts.hpp"
#include "engine/minimal/minimal_search.hpp"
#include "engine/preference.hpp"
#include "engine/proof/ask_solver.hpp"
#include "engine/proof/certify.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/support/axiom_files.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

Stop enough() { return Stop{}.within(60); }  // some tenths of a second are used

/// path, place and segment under names that the program does not know; and the directions in which
/// a path ends.
const std::string declarations = R"(
(set-info :extent (line ((q DState)) (along q) (opp (along q))))
(set-info :extent (spot ((q DState)) (place q)))
(set-info :extent (hall ((q DState) (r DState) (s DState))
                   :where (and (leads q travel r) (leads r turn_around s)) q s))
(set-info :extent (dead_end ((q DState)) :where (ends q) (along q)))
)";

AxiomSet minimising(const std::string& names) {
  AxiomFiles files = shipped_files();
  files["preference.smt2"] = declarations + "(set-info :minimise (" + names + "))\n";
  return AxiomSet::parse(files);
}

MapTree solved(const Trace& trace, const AxiomSet& axioms, bool planar = false) {
  return tree_of(trace, {.theory = {.axioms = axioms, .planar = planar}, .check = Check::solver});
}

/// Counted from the map alone: each path has two ends, but for one that closes on itself.
std::size_t dead_ends(const TopologicalMap& map) {
  std::size_t count = 0;
  for (const auto& path : map.paths)
    count += static_cast<std::size_t>(std::ranges::count_if(path.ends, [&](const PlaceArm& end) {
      return !map.places[end.place.index()].star.has_gateway(end.arm);
    }));
  return count;
}

using Sizes = std::vector<std::size_t>;

/// Dead ends, then places.
Sizes sizes(const Trace& trace, const Association& map) {
  const TopologicalMap written = make_map(trace, map);
  return {dead_ends(written), written.places.size()};
}

/// Those of every map of the trace that have the least.
std::vector<Association> with_fewest_dead_ends(const Trace& trace, bool planar) {
  std::vector<Association> result;
  for (const Association& map : every_map(trace, {.planar = planar})) {
    if (!result.empty() && sizes(trace, map) > sizes(trace, result.front())) continue;
    if (!result.empty() && sizes(trace, map) < sizes(trace, result.front())) result.clear();
    result.push_back(map);
  }
  return result;
}

}  // namespace

TEST_CASE("what is declared as a shipped extent counts what each map tells",
          "[engine][extents][property]") {
  const AxiomSet own = minimising("line spot hall dead_end");
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Trace trace = seeded_walk(seed, 4 + seed % 7).trace;
    INFO(to_keep(seed, trace));
    for (const Association& association : maps_of(tree_of(trace, seed % 2 == 0))) {
      const TopologicalMap map = make_map(trace, association);
      const ArmTable table(trace);
      const LeastClosure closure(own, map_facts(table, table.named(association)));
      CHECK(closure.extents() == extents_of(map));
      CHECK(closure.minimised() ==
            Sizes{map.paths.size(), map.places.size(), map.segments.size(), dead_ends(map)});
    }
  }
}

TEST_CASE("minimal models of extents declared again are the shipped ones",
          "[engine][extents][property]") {
  const AxiomSet own = minimising("line spot");
  for (unsigned seed = 0; seed < 12; ++seed) {
    const Trace trace = seeded_walk(seed, 4 + seed % 5).trace;
    INFO(to_keep(seed, trace));
    const bool planar = seed % 2 == 0;
    const MapTree shipped = solved(trace, shipped_with(), planar);
    const MapTree tree = solved(trace, own, planar);
    CHECK(std::ranges::equal(tree.minimal(), shipped.minimal()));
    CHECK(tree.by_preference() == shipped.by_preference());
    CHECK(minimal_of(tree) == minimal_of(tree_of(trace, planar)));
    CHECK(certify(trace, {own, planar}, minimal_of(tree), enough()) == Certificate::shown);
  }
}

TEST_CASE("minimal models of an extent of one's own are those of all maps, and are certified",
          "[engine][extents][certify][property]") {
  const AxiomSet own = minimising("dead_end place");
  std::size_t others = 0;
  for (unsigned seed = 0; seed < 24; ++seed) {
    const Trace trace = seeded_walk(seed, 4 + seed % 3).trace;
    INFO(to_keep(seed, trace));
    const bool planar = seed % 2 == 0;
    const MapTree tree = solved(trace, own, planar);
    const std::vector<Association> minimal = minimal_of(tree);
    CHECK(minimal == with_fewest_dead_ends(trace, planar));
    CHECK(certify(trace, {own, planar}, minimal, enough()) == Certificate::shown);

    // Classes come in order, each of one size.
    Sizes before;
    const auto classes = tree.by_preference();
    CHECK(std::ranges::equal(classes.front(), tree.minimal()));
    for (const auto& alike : classes) {
      std::set<Sizes> found;
      tree.for_each(alike, [&](HypothesisId, std::span<const Arrival> map) {
        found.insert(sizes(trace, {map.begin(), map.end()}));
      });
      REQUIRE(found.size() == 1);
      CHECK(before < *found.begin());
      before = *found.begin();
    }

    std::vector<Association> worse = maps_of(tree);
    std::erase_if(worse, [&](const auto& map) { return std::ranges::count(minimal, map) > 0; });
    if (worse.empty()) continue;
    ++others;
    CHECK(certify(trace, {own, planar}, {&worse.back(), 1}, enough()) == Certificate::refuted);
    CHECK(certify(trace, {own, planar}, minimal, Stop{}.within(0)) == Certificate::not_shown);
  }
  CHECK(others > 5);
}

TEST_CASE("the solver answers over minimal models of an extent of one's own as the list does",
          "[engine][extents][query][property]") {
  const AxiomSet own = minimising("dead_end place");
  std::size_t possible = 0;
  for (unsigned seed = 0; seed < 40 && possible < 3; ++seed) {
    const Trace trace = seeded_walk(seed, 6 + seed % 3).trace;
    INFO(to_keep(seed, trace));
    const MapTree tree = solved(trace, own);
    std::vector<Query> queries;
    for (std::size_t k = 0; k + 1 < trace.visits.size(); ++k)
      queries.push_back({"", {Claim::Same{VisitId(k), VisitId(trace.visits.size() - 1)}}, {}});
    const auto answers = ask(minimal_maps(tree), queries).value();
    const auto solved = ask_solver(trace, {own}, queries, true, enough());
    REQUIRE(solved.size() == answers.size());
    for (std::size_t i = 0; i < queries.size(); ++i) {
      CHECK(solved[i].modality() == answers[i].modality());
      possible += answers[i].modality() == Modality::possible ? 1U : 0U;
    }
  }
  CHECK(possible > 0);
}

TEST_CASE("what does not know extents of one's own says so", "[engine][extents]") {
  const Theory theory{.axioms = minimising("path dead_end")};
  CHECK_THROWS_AS(MapTree(theory), std::invalid_argument);
  CHECK_THROWS_AS(MapTree({.theory = theory, .check = Check::both}), std::invalid_argument);
  CHECK_THROWS_AS(MinimalSearch({.theory = theory}), std::invalid_argument);
}
