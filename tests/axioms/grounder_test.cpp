#include "axioms/grounder.hpp"

#include <algorithm>
#include <random>
#include <set>

#include "axioms/axiom_solver.hpp"
#include "tests/axioms/forward_chaining.hpp"
#include "tests/axioms/plain_logic.hpp"
#include "tests/support/axiom_files.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

constexpr unsigned timeout_ms = 10'000;

/// Forms that the shipped axioms do without: relations under `not` in a premise, `or`, equalities
/// in premises, variables for places and paths, constants of each.
const std::string other_forms = R"(
(declare-const home Place)
(declare-fun beside (Place Place) Bool)
(declare-fun crosses (DirectedPath DirectedPath) Bool)
(assert (! (forall ((q DState) (r DState))
  (=> (and (next q r) (not (opposite q r))) (order q r))) :named or_opposite))
(assert (! (forall ((q DState) (r DState))
  (=> (opposite q r) (or (order q r) (order r q)))) :named either_way))
(assert (! (forall ((q DState) (r DState))
  (=> (and (order q r) (ends q)) false)) :named none_after_end))
(assert (! (forall ((q DState) (r DState))
  (=> (and (opposite q r) (ends r)) false)) :named none_opposite_end))
(assert (! (forall ((q DState) (r DState))
  (=> (leads q turn_around r) (not (and (not (ends q)) (not (ends r)))))) :named one_ends))
(assert (! (forall ((q DState) (r DState))
  (=> (and (ends q) (sees r v_ends)) (beside (place q) (place r)))) :named near_end))
(declare-const v_ends View)
(assert (! (forall ((p Place) (s Place) (t Place))
  (=> (and (beside p s) (beside t s) (beside home s)) (= p t))) :named one_neighbour))
(assert (! (forall ((q DState)) (=> (ends q) (= (place q) home))) :named ends_at_home))
(assert (! (forall ((q DState) (r DState))
  (=> (and (next q r) (= (place q) (place r))) (crosses (along q) (along r)))) :named cross))
(assert (! (forall ((q DState) (r DState) (w DirectedPath))
  (=> (and (crosses (along q) w) (sees q v_ends) (next r r) (= (opp (along r)) w)) (ends q)))
  :named ends_where_crossed))
(assert (! (forall ((w DirectedPath)) (=> (crosses w w) (= w (opp w)))) :named no_crossing))
(assert (! (forall ((w DirectedPath)) (=> (and (crosses w w) (= w (opp w))) false))
  :named no_self_crossing))
)";

AxiomSet with_other_forms(bool with_shipped) {
  AxiomFiles files = shipped_files();
  const AxiomSet shipped = AxiomSet::shipped();
  if (!with_shipped)
    for (const Axiom& axiom : shipped.axioms())
      if (!axiom.by_signature) files = with_axiom(files, axiom.name);
  files["other_forms.smt2"] = other_forms;
  return AxiomSet::parse(files);
}

/// Facts of four dstates, three actions and two views, in any combination.
std::vector<Fact> random_facts(std::mt19937& random, const AxiomSet& axioms) {
  const auto below = [&](std::size_t n) { return random() % n; };
  const auto dstate = [&] { return "d0_" + std::to_string(below(4)); };
  const std::vector<std::string> actions{"travel", "turn_around", "turn_clockwise"};
  const std::vector<std::string> views = axioms.functions().contains("v_ends")
                                             ? std::vector<std::string>{"v0", "v_ends"}
                                             : std::vector<std::string>{"v0", "v1"};
  std::vector<Fact> facts;
  for (std::size_t left = 4 + below(6); left > 0; --left) {
    switch (below(8)) {
      case 0:
      case 1:
        facts.push_back({"leads", {dstate(), actions[below(3)], dstate()}});
        break;
      case 2:
        facts.push_back({"sees", {dstate(), views[below(2)]}});
        break;
      case 3:
        facts.push_back({"is_turn", {actions[below(3)]}});
        break;
      case 4:
        facts.push_back({"next", {dstate(), dstate()}});
        break;
      case 5:
        facts.push_back({"opposite", {dstate(), dstate()}});
        break;
      case 6:
        facts.push_back({"ends", {dstate()}});
        break;
      default:
        facts.push_back({"order", {dstate(), dstate()}});
    }
  }
  return facts;
}

Verdict solver_verdict(const AxiomSet& axioms, std::span<const Fact> facts) {
  AxiomSolver solver(axioms, timeout_ms);
  solver.add(facts);
  return solver.check();
}

/// Instances as text, each as often as it is found.
std::multiset<std::string> instances(Grounder& grounder, std::span<const Fact> facts) {
  std::multiset<std::string> result;
  for (const Fact& fact : facts)
    grounder.add(fact, [&](const Grounder::Instance& instance) {
      std::string text = instance.axiom->name;
      for (const Grounder::TermId id : instance.binding) text += " " + grounder.term(id).symbol;
      result.insert(text);
    });
  return result;
}

}  // namespace

TEST_CASE("joining decides as all instances over all constants do", "[axioms][property]") {
  const bool shipped = GENERATE(true, false);
  const AxiomSet axioms = shipped ? AxiomSet::shipped() : with_other_forms(false);
  std::mt19937 random(20100);
  std::map<Verdict, int> times;
  for (int i = 0; i < 80; ++i) {
    const std::vector<Fact> facts = random_facts(random, axioms);
    std::string told;
    for (const Fact& fact : facts) told += fact_text(fact) + " ";
    INFO(told);
    const Verdict verdict = plain_verdict(axioms, facts);
    CHECK(solver_verdict(axioms, facts) == verdict);
    ++times[verdict];
  }
  CHECK(times[Verdict::consistent] >= 8);
  CHECK(times[Verdict::inconsistent] >= 8);
  CHECK(times[Verdict::undecided] == 0);
}

TEST_CASE("a relation under not in a premise is joined over", "[axioms]") {
  // q before r: opposite or in order; none is opposite an end, none follows one.
  const std::vector<Fact> facts{{"next", {"d0_0", "d0_1"}}, {"ends", {"d0_0"}}, {"ends", {"d0_1"}}};
  const AxiomSet axioms = with_other_forms(false);
  CHECK(plain_verdict(axioms, facts) == Verdict::inconsistent);
  CHECK(solver_verdict(axioms, facts) == Verdict::inconsistent);
  CHECK(solver_verdict(axioms, std::span(facts).first(2)) == Verdict::consistent);
}

TEST_CASE("the solver decides as forward chaining does", "[axioms][property]") {
  const AxiomSet axioms = AxiomSet::shipped();
  std::mt19937 random(2004);
  std::map<Verdict, int> times;
  for (int i = 0; i < 500; ++i) {
    const std::vector<Fact> facts = random_facts(random, axioms);
    std::string told;
    for (const Fact& fact : facts) told += fact_text(fact) + " ";
    INFO(told);
    const Verdict verdict = ForwardChaining(facts).verdict();
    CHECK(solver_verdict(axioms, facts) == verdict);
    ++times[verdict];
  }
  CHECK(times[Verdict::consistent] >= 60);
  CHECK(times[Verdict::inconsistent] >= 60);
}

TEST_CASE("the order of facts changes neither instances nor verdict", "[axioms][property]") {
  const AxiomSet axioms = GENERATE(true, false) ? AxiomSet::shipped() : with_other_forms(true);
  std::mt19937 random(64);
  for (int i = 0; i < 50; ++i) {
    std::vector<Fact> facts = random_facts(random, axioms);
    Grounder grounder(axioms);
    const auto found = instances(grounder, facts);
    const Verdict verdict = solver_verdict(axioms, facts);
    std::shuffle(facts.begin(), facts.end(), random);
    Grounder other(axioms);
    CHECK(instances(other, facts) == found);
    CHECK(solver_verdict(axioms, facts) == verdict);
  }
}

TEST_CASE("what was popped is forgotten", "[axioms][property]") {
  const AxiomSet axioms = GENERATE(true, false) ? AxiomSet::shipped() : with_other_forms(true);
  std::mt19937 random(10);
  AxiomSolver solver(axioms, timeout_ms);
  Grounder grounder(axioms);
  std::vector<std::vector<Fact>> levels;
  for (int step = 0; step < 60; ++step) {
    if (levels.size() < 4 && random() % 2 == 0) {
      std::vector<Fact> facts = random_facts(random, axioms);
      facts.resize(2);
      solver.push();
      solver.add(facts);
      grounder.push();
      const auto found = instances(grounder, facts);
      std::vector<Fact> below;
      for (const auto& level : levels) below.insert(below.end(), level.begin(), level.end());
      Grounder fresh(axioms);
      instances(fresh, below);
      CHECK(instances(fresh, facts) == found);
      levels.push_back(facts);
    } else if (!levels.empty()) {
      solver.pop();
      grounder.pop();
      levels.pop_back();
    }
    std::vector<Fact> all;
    for (const auto& level : levels) all.insert(all.end(), level.begin(), level.end());
    CHECK(solver.check() == solver_verdict(axioms, all));
  }
}

}  // namespace asterism
