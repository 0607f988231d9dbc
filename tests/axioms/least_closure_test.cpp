#include "axioms/least_closure.hpp"

#include <map>
#include <random>

#include "axioms/axiom_solver.hpp"
#include "tests/axioms/forward_chaining.hpp"
#include "tests/axioms/plain_logic.hpp"
#include "tests/support/axiom_files.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

constexpr unsigned timeout_ms = 10'000;
const std::vector<std::string> dstates{"q", "r", "s", "t"};

/// Facts of four dstates, whose pairs of opposites make stars now and then.
std::vector<Fact> random_facts(std::mt19937& random) {
  const auto below = [&](std::size_t n) { return random() % n; };
  const auto dstate = [&] { return dstates[below(dstates.size())]; };
  std::vector<Fact> facts{{"is_turn", {"turn_around"}}, {"is_turn", {"turn_clockwise"}}};
  for (const std::string& name : dstates) facts.push_back({"sees", {name, "v0"}});
  for (std::size_t left = 2 + below(5); left > 0; --left) {
    switch (below(6)) {
      case 0:
        facts.push_back({"next", {dstate(), dstate()}});
        break;
      case 1:
      case 2:
        facts.push_back({"opposite", {dstate(), dstate()}});
        break;
      case 3:
        facts.push_back({"leads", {dstate(), "travel", dstate()}});
        break;
      case 4:
        facts.push_back({"leads", {dstate(), "turn_around", dstate()}});
        break;
      default:
        facts.push_back({"order", {dstate(), dstate()}});
    }
  }
  return facts;
}

std::string same_path() {
  std::string text = "(or";
  std::string left = "(along q)";
  for (int i = 0; i < 4; ++i, left = "(opp " + left + ")") {
    std::string right = "(along r)";
    for (int j = 0; j < 4; ++j, right = "(opp " + right + ")")
      text += " (= " + left + " " + right + ")";
  }
  return text + ")";
}

/// The shipped axioms, and relations that deny of two dstates what may be entailed.
AxiomSet with_goals() {
  AxiomFiles files = shipped_files();
  std::string& text = files["goals.smt2"];
  for (const auto& [name, formula] :
       std::map<std::string, std::string>{{"not_in_order", "(order q r)"},
                                          {"not_one_place", "(= (place q) (place r))"},
                                          {"not_one_path", same_path()}})
    text += "(declare-fun " + name + " (DState DState) Bool)\n(assert (! (forall ((q DState) " +
            "(r DState)) (=> (" + name + " q r) (not " + formula + "))) :named deny_" + name +
            "))\n";
  return AxiomSet::parse(files);
}

/// Whether axioms and facts, in the solver, entail what this relation denies.
bool entails(AxiomSolver& solver, const std::string& goal, const std::string& q,
             const std::string& r) {
  solver.push();
  solver.add(std::vector<Fact>{{goal, {q, r}}});
  const Verdict verdict = solver.check();
  solver.pop();
  return verdict == Verdict::inconsistent;
}

/// Classes of dstates under what is entailed of pairs.
std::size_t classes(AxiomSolver& solver, const std::string& goal) {
  std::map<std::string, std::string> first;
  for (const std::string& dstate : dstates) first[dstate] = dstate;
  for (std::size_t i = 0; i < dstates.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (!entails(solver, goal, dstates[i], dstates[j])) continue;
      const std::string joined = first[dstates[i]];
      for (auto& [dstate, named] : first)
        if (named == joined) named = first[dstates[j]];
    }
  std::set<std::string> result;
  for (const auto& [dstate, named] : first) result.insert(named);
  return result.size();
}

}  // namespace

TEST_CASE("the least closure holds what the solver finds entailed", "[axioms][closure][property]") {
  const AxiomSet axioms = AxiomSet::shipped();
  const AxiomSet goals = with_goals();
  REQUIRE(LeastClosure::exists(axioms));
  std::mt19937 random(1904);
  AxiomSolver solver(goals, timeout_ms);
  int consistent = 0;
  std::map<std::size_t, int> paths;
  for (int i = 0; i < 150; ++i) {
    const std::vector<Fact> facts = random_facts(random);
    std::string told;
    for (const Fact& fact : facts) told += fact_text(fact) + " ";
    INFO(told);
    solver.push();
    solver.add(facts);
    LeastClosure closure(axioms, facts);
    CHECK(closure.is_contradictory() == (solver.check() == Verdict::inconsistent));
    CHECK(closure.is_contradictory() ==
          (ForwardChaining(facts).verdict() == Verdict::inconsistent));
    if (!closure.is_contradictory()) {
      ++consistent;
      for (const std::string& q : dstates)
        for (const std::string& r : dstates)
          CHECK(closure.holds({"order", {q, r}}) == entails(solver, "not_in_order", q, r));
      CHECK(closure.extents().places == classes(solver, "not_one_place"));
      CHECK(closure.extents().paths == classes(solver, "not_one_path"));
      ++paths[closure.extents().paths];
    }
    solver.pop();
  }
  CHECK(consistent > 25);
  CHECK(paths.size() > 2);
}

TEST_CASE("a travel and its way back are one segment", "[axioms][closure]") {
  std::vector<Fact> facts{{"opposite", {"q", "r"}},
                          {"opposite", {"s", "t"}},
                          {"leads", {"q", "travel", "s"}},
                          {"is_turn", {"turn_around"}}};
  const AxiomSet axioms = AxiomSet::shipped();
  LeastClosure there(axioms, facts);
  CHECK(there.holds({"leads", {"t", "travel", "r"}}));
  CHECK_FALSE(there.holds({"leads", {"r", "travel", "t"}}));
  CHECK_FALSE(there.holds({"order", {"unheard", "of"}}));
  CHECK(there.extents() == Extents{.paths = 1, .places = 2, .segments = 1});
  facts.push_back({"leads", {"t", "travel", "r"}});
  CHECK(LeastClosure(axioms, facts).extents() == there.extents());
  // Round to where it began, by the other end of the path.
  facts.push_back({"leads", {"s", "travel", "q"}});
  CHECK(LeastClosure(axioms, facts).is_contradictory());
}

TEST_CASE("functions of equal terms are equal", "[axioms][closure]") {
  AxiomFiles files = shipped_files();
  files["more.smt2"] =
      "(assert (! (forall ((q DState) (r DState) (v View)) (=> (and (sees q v) (sees r v) "
      "(= (opp (along q)) (opp (along r)))) (next q r))) :named more))";
  const AxiomSet axioms = AxiomSet::parse(files);
  const std::vector<Fact> facts{
      {"sees", {"q", "v0"}}, {"sees", {"r", "v0"}}, {"leads", {"q", "travel", "r"}}};
  CHECK(LeastClosure(axioms, facts).holds({"next", {"r", "q"}}));
  CHECK_FALSE(LeastClosure(axioms, std::span(facts).first(2)).holds({"next", {"r", "q"}}));
}

TEST_CASE("extents are counted as they are declared", "[axioms][closure][extents]") {
  const auto [declaration, size] = GENERATE(table<std::string, std::size_t>({
      {"((x DState)) x", 5},
      {"((x DState)) (along x)", 3},
      {"((x DState)) (opp (along x))", 3},
      {"((x DState)) (along x) (opp (along x))", 2},
      {"((x DState)) :where (ends x) x", 1},
      {"((x DState)) :where (not (ends x)) x", 4},
      {"((x DState) (y DState)) :where (leads x travel y) (place y)", 2},
      {"((x DState) (y DState)) :where (leads x travel y) x y", 2},
      {"((x DState) (y DState)) :where (and (not (ends x)) (= (along x) (along y)) (ends y)) x", 1},
      {"((x DState) (y DState)) (place x) (place y)", 1},
      {"((x DState)) :where (leads x travel x) x", 0},
      {"((x DState)) :where (on (along x) (place x)) (place x)", 3},
  }));
  AxiomFiles files = shipped_files();
  files["own.smt2"] = "(set-info :extent (own " + declaration + "))\n";
  std::string& preference = files["preference.smt2"];
  preference.replace(preference.find("(path place)"), 12, "(path own segment)");
  INFO(declaration);
  // One corridor of two places, ending in s, and a dstate o on another.
  const std::vector<Fact> facts{{"opposite", {"q", "r"}},        {"opposite", {"r", "q"}},
                                {"opposite", {"s", "t"}},        {"opposite", {"t", "s"}},
                                {"leads", {"q", "travel", "s"}}, {"ends", {"s"}},
                                {"is_turn", {"turn_around"}},    {"sees", {"o", "v0"}}};
  CHECK(LeastClosure(AxiomSet::parse(files), facts).minimised() ==
        std::vector<std::size_t>{2, size, 1});
}

TEST_CASE("where conclusions leave a choice there is no least closure", "[axioms][closure]") {
  AxiomFiles files = shipped_files();
  for (const std::string formula : {"(=> (opposite q r) (or (order q r) (order r q)))",
                                    "(=> (and (next q r) (not (opposite q r))) (order q r))",
                                    "(=> (next q r) (not (and (ends q) (ends r))))"}) {
    files["more.smt2"] =
        "(assert (! (forall ((q DState) (r DState)) " + formula + ") :named more))";
    CHECK_FALSE(LeastClosure::exists(AxiomSet::parse(files)));
  }
  files["more.smt2"] =
      "(assert (! (forall ((q DState) (r DState)) (=> (next q r) (not (ends q)))) :named more))";
  const AxiomSet axioms = AxiomSet::parse(files);
  REQUIRE(LeastClosure::exists(axioms));
  const std::vector<Fact> facts{{"next", {"q", "r"}}, {"ends", {"q"}}};
  CHECK(LeastClosure(axioms, facts).is_contradictory());
  CHECK_FALSE(LeastClosure(axioms, std::span(facts).first(1)).is_contradictory());
}
