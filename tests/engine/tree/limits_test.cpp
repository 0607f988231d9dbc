#include <algorithm>

#include "engine/arm_table.hpp"
#include "engine/tree/both_engines.hpp"
#include "engine/tree/solver_engine.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/support/axiom_files.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/known_traces.hpp"

using namespace asterism;

namespace {

/// What a tree tells, to see that it stays.
struct Told {
  std::vector<Association> maps;
  std::vector<Association> minimal;
  std::vector<std::uint64_t> per_visit;
  std::size_t visits = 0;
  friend bool operator==(const Told&, const Told&) = default;
};
Told told(const MapTree& tree) {
  return {maps_of(tree),
          minimal_of(tree),
          {tree.per_visit().begin(), tree.per_visit().end()},
          tree.trace().visits.size()};
}

/// Drives an engine down every branch, as the tree does.
void grow(BothEngines<NativeEngine, SolverEngine>& engines, VisitId k, VisitId end) {
  if (k == end) return;
  std::vector<std::pair<ArmId, Step>> children;
  engines.for_each_child(k, [&](ArmId arm, Step step) { children.emplace_back(arm, step); });
  for (const auto& [arm, step] : children) {
    engines.enter(k, arm, step);
    grow(engines, k.next(), end);
    engines.leave(k, arm, step);
  }
}

/// The shipped axioms, and that dstates that have an opposite one (all of them) fit into fewer
/// holes. Z3 needs long to see that they do not.
AxiomSet with_pigeonholes(int holes) {
  AxiomFiles files = shipped_files();
  std::string text;
  std::string some;
  for (int i = 0; i < holes; ++i) {
    const std::string hole = "hole" + std::to_string(i);
    text += "(declare-fun " + hole + " (DState) Bool)\n";
    text += "(assert (! (forall ((q DState) (r DState)) (=> (and (" + hole + " q) (" + hole +
            " r)) (= q r))) :named alone_in_" + hole + "))\n";
    some += " (" + hole + " q)";
  }
  text += "(assert (! (forall ((q DState) (r DState)) (=> (opposite q r) (or" + some +
          "))) :named in_some_hole))\n";
  files["zz_pigeonholes.smt2"] = text;
  return AxiomSet::parse(files);
}

}  // namespace

TEST_CASE("a level with too many hypotheses leaves the tree as it was", "[engine][limits]") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Trace trace = seeded_walk(seed, 12).trace;
    INFO(to_keep(seed, trace));
    const auto whole = tree_of(trace, false);
    const std::uint64_t most = *std::ranges::max_element(whole.per_visit());
    MapTree exact({.theory = {.axioms = shipped_with()}, .max_hypotheses = most});
    CHECK(exact.extend(trace.visits) == MapTree::Growth::complete);
    if (most == 1) continue;

    MapTree tree({.theory = {.axioms = shipped_with()}, .max_hypotheses = most - 1});
    CHECK(tree.extend(trace.visits) == MapTree::Growth::too_many);
    CHECK(told(tree) == Told{});
    std::size_t k = 0;
    Told before;
    for (; k < trace.visits.size(); ++k) {
      before = told(tree);
      if (tree.extend(trace.visits[k]) != MapTree::Growth::complete) break;
    }
    REQUIRE(k < trace.visits.size());
    CHECK(whole.per_visit()[k] == most);
    CHECK(told(tree) == before);
    CHECK(tree.extend(std::span(trace.visits).subspan(k)) == MapTree::Growth::too_many);
    CHECK(told(tree) == before);
    // What it holds is what a fresh tree holds, and it can be left and looked at as before.
    const auto seen = std::span(trace.visits).first(k);
    MapTree fresh({.axioms = shipped_with()});
    REQUIRE(fresh.extend(seen) == MapTree::Growth::complete);
    CHECK(told(fresh) == before);
  }
}

TEST_CASE("a tree told to stop can go on later", "[engine][limits]") {
  const auto known = known_traces();
  const Trace& trace = std::ranges::find(known, "eight-crossings", [](const auto& k) {
                         return k.trace.name;
                       })->trace;
  bool goes_on = true;
  std::size_t questions = 0;
  MapTree tree({.theory = {.axioms = shipped_with(), .planar = true}, .check = Check::both});
  const auto stop = [&] {
    return Stop{.watch = [&](const Standing& now) -> std::optional<std::string> {
      ++questions;
      CHECK(now.visit < trace.visits.size());
      CHECK(now.maps > 0);
      if (goes_on) return std::nullopt;
      return "test";
    }};
  };
  REQUIRE(tree.extend(std::span(trace.visits).first(5), stop()) == MapTree::Growth::complete);
  const Told before = told(tree);
  const auto rest = std::span(trace.visits).subspan(5);
  goes_on = false;
  REQUIRE(tree.extend(rest, stop()) == MapTree::Growth::stopped);
  CHECK(questions > 0);
  CHECK(told(tree) == before);
  goes_on = true;
  REQUIRE(tree.extend(rest, stop()) == MapTree::Growth::complete);
  CHECK(told(tree) == told(tree_of(trace, true)));
}

TEST_CASE("a visit that cannot follow leaves the tree as it was", "[engine][limits]") {
  const Trace trace = seeded_walk(8, 6).trace;
  MapTree tree({.axioms = shipped_with()});
  REQUIRE(tree.extend(std::span(trace.visits).first(4)) == MapTree::Growth::complete);
  const Told before = told(tree);
  std::vector<Visit> visits(trace.visits.begin() + 4, trace.visits.end());
  visits.back().entered_by.reset();
  CHECK_THROWS_AS(tree.extend(visits), std::invalid_argument);
  CHECK(told(tree) == before);
  REQUIRE(tree.extend(std::span(trace.visits).subspan(4)) == MapTree::Growth::complete);
  CHECK(told(tree) == told(tree_of(trace, false)));
}

TEST_CASE("what the solver does not decide in time stays, and is counted", "[engine][limits]") {
  const Trace trace = seeded_walk(4, 3).trace;
  INFO(to_keep(4, trace));
  std::size_t arms = 0;
  for (const Visit& visit : trace.visits) arms += visit.star.size();
  const AxiomSet axioms = with_pigeonholes(static_cast<int>(arms) - 1);
  MapTree tree({.theory = {.axioms = axioms}, .check = Check::solver});
  REQUIRE(tree.extend(trace.visits, {.question_s = 0.02}) == MapTree::Growth::complete);
  CHECK(tree.undecided() > 0);
  const auto kept = maps_of(tree);
  const auto consistent = maps_of(tree_of(trace, false));
  CHECK(std::includes(kept.begin(), kept.end(), consistent.begin(), consistent.end()));
}

TEST_CASE("axioms the native engine does not know need the solver", "[engine][axioms]") {
  const AxiomSet axioms = AxiomSet::parse(with_axiom(shipped_files(), "transitive"));
  for (const Check check : {Check::native, Check::both})
    CHECK_THROWS_AS(MapTree({.theory = {.axioms = axioms}, .check = check}), std::invalid_argument);
  CHECK_NOTHROW(MapTree({.theory = {.axioms = axioms}, .check = Check::solver}));
}

TEST_CASE("a difference between the engines stops where they differ", "[engine][solver]") {
  std::size_t differences = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Trace trace = seeded_walk(seed, 6).trace;
    INFO(to_keep(seed, trace));
    const auto all = tree_of(trace, false);
    const auto fewer = tree_of(trace, {.theory = {.axioms = shipped_with("one_segment")}});
    if (std::ranges::equal(all.per_visit(), fewer.per_visit())) continue;
    ++differences;
    ArmTable table;
    for (const Visit& visit : trace.visits) table.append(visit);
    const Theory theory{shipped_with()};
    BothEngines engines(NativeEngine(table, NativeEngine::Rules{.one_segment = true}),
                        SolverEngine(table, theory));
    engines.reset({});
    try {
      grow(engines, VisitId(0), VisitId(trace.visits.size()));
      FAIL("the engines agree");
    } catch (const DifferenceError& error) {
      const std::size_t visits = std::get<Trace>(error.shortest).visits.size();
      CHECK(all.per_visit()[visits - 1] != fewer.per_visit()[visits - 1]);
      CHECK_THAT(error.what(), Catch::Contains("visit " + std::to_string(visits - 1)) &&
                                   Catch::Contains("inconsistent to the native engine"));
    }
  }
  CHECK(differences >= 3);
}
