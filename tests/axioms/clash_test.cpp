#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <set>

#include "axioms/axiom_solver.hpp"
#include "engine/facts.hpp"
#include "engine/map_tree.hpp"
#include "tests/axioms/plain_logic.hpp"
#include "tests/support/axiom_files.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/known_traces.hpp"

namespace asterism {
namespace {

constexpr unsigned timeout_ms = 10'000;

/// What hypotheses of the first visits say, and all their children, kept or not.
std::vector<std::vector<Fact>> facts_of_candidates(const std::string& name, std::size_t visits) {
  const auto traces = known_traces();
  const auto known = std::find_if(traces.begin(), traces.end(), [&](const KnownTrace& other) {
    return other.trace.name == name;
  });
  const std::span seen = std::span(known->trace.visits).first(visits);
  ArmTable table;
  for (const Visit& visit : seen) table.append(visit);
  MapTree tree;
  REQUIRE(tree.extend(seen.first(visits - 1)) == MapTree::Growth::complete);
  std::vector<std::vector<Fact>> result;
  tree.for_each([&](HypothesisId, std::span<const Arrival> arrivals) {
    std::vector<ArmIndex> named = table.named(arrivals);
    named.push_back(0);
    for (ArmIndex arm = 0; arm < table.size(); ++arm) {
      const std::size_t visit = table.visit_of(arm);
      const bool is_new = visit == visits - 1;
      if (is_new ? arm != table.entered(visit) : table.visit_of(named[visit]) != visit) continue;
      named.back() = arm;
      std::vector<Fact> facts = general_facts();
      for (std::size_t k = 1; k <= visits; ++k)
        for (const Fact& fact : visit_facts(table, std::span(named).first(k)))
          facts.push_back(fact);
      result.push_back(std::move(facts));
    }
  });
  return result;
}

Verdict verdict(const AxiomSet& axioms, std::span<const Fact> facts) {
  AxiomSolver solver(axioms, timeout_ms);
  solver.add(facts);
  return solver.check();
}

/// The instances and facts of a clash, as assertions.
std::vector<std::string> members(const AxiomSet& axioms, const Clash& clash) {
  std::vector<std::string> result;
  for (const auto& [name, binding] : clash.steps) {
    const auto axiom = std::find_if(axioms.axioms().begin(), axioms.axioms().end(),
                                    [&](const Axiom& other) { return other.name == name; });
    REQUIRE(axiom != axioms.axioms().end());
    result.push_back(instance_text(*axiom, Binding(binding.begin(), binding.end())));
  }
  for (const Fact& fact : clash.facts) result.push_back(fact_text(fact));
  return result;
}

std::set<std::string> names(const Clash& clash) {
  std::set<std::string> result;
  for (const Clash::Step& step : clash.steps) result.insert(step.axiom);
  return result;
}

/// What a program prints about a problem; nothing if there is no such program.
std::string answer(const std::string& program, const std::string& problem) {
  if (std::system(("command -v " + program + " >/dev/null").c_str()) != 0) return "";
  const auto file = std::filesystem::temp_directory_path() /
                    ("asterism-" + std::to_string(std::random_device()()) + ".smt2");
  std::ofstream(file) << problem;
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(
      popen((program + " " + file.string() + " 2>&1").c_str(), "r"), pclose);
  std::string result;
  std::array<char, 256> line{};
  while (std::fgets(line.data(), line.size(), pipe.get()) != nullptr) result += line.data();
  std::filesystem::remove(file);
  return result;
}

}  // namespace

TEST_CASE("a clash is refuted, and nothing in it can be spared", "[axioms]") {
  const AxiomSet axioms = AxiomSet::shipped();
  std::size_t clashes = 0;
  std::set<std::string> axioms_named;
  for (const auto& [trace, visits] : std::map<std::string, std::size_t>{
           {"eight-crossings", 5}, {"square-three-laps", 4}, {"grid-4x4-snake", 4}})
    for (const std::vector<Fact>& facts : facts_of_candidates(trace, visits)) {
      const auto clash = find_clash(axioms, facts, 0, timeout_ms);
      REQUIRE(clash.has_value() == (verdict(axioms, facts) == Verdict::inconsistent));
      if (!clash) continue;
      ++clashes;
      axioms_named.merge(names(*clash));
      const std::string declarations = declarations_text(axioms, facts);
      const std::vector<std::string> all = members(axioms, *clash);
      CHECK(verdict_of(declarations, all) == Verdict::inconsistent);
      for (std::size_t i = 0; i < all.size(); ++i) {
        std::vector<std::string> rest = all;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
        INFO(all[i]);
        CHECK(verdict_of(declarations, rest) == Verdict::consistent);
      }
      for (const Fact& fact : clash->facts)
        CHECK(std::find(facts.begin(), facts.end(), fact) != facts.end());
    }
  CHECK(clashes > 40);
  CHECK(axioms_named.contains("view"));
  CHECK(axioms_named.contains("irreflexive"));
}

TEST_CASE("a clash names the axioms that make it", "[axioms]") {
  const AxiomSet axioms = AxiomSet::shipped();
  const auto clash_of = [&](const std::vector<Fact>& facts, std::size_t background) {
    return find_clash(axioms, facts, background, timeout_ms).value();
  };
  const Fact sees_v{"sees", {"q", "v"}};
  const Fact sees_w{"sees", {"q", "w"}};
  const Fact ends{"ends", {"r"}};
  CHECK(names(clash_of({ends, sees_v, sees_w}, 0)) == std::set<std::string>{"view"});
  CHECK(clash_of({ends, sees_v, sees_w}, 0).facts == std::vector{sees_v, sees_w});
  CHECK(clash_of({ends, sees_v, sees_w}, 2).facts == std::vector{sees_w});

  // A path that goes on to its third place, which is its first again.
  const std::vector<Fact> loop{{"is_turn", {"a"}},
                               {"leads", {"q", "travel", "r"}},
                               {"leads", {"r", "travel", "s"}},
                               {"leads", {"q", "a", "s"}}};
  CHECK(names(clash_of(loop, 1)) ==
        std::set<std::string>{"order", "transitive", "turn", "irreflexive"});
  CHECK(clash_of(loop, 1).facts == std::vector(loop.begin() + 1, loop.end()));
  CHECK_FALSE(find_clash(axioms, std::span(loop).first(3), 0, timeout_ms));
}

TEST_CASE("other solvers give the same verdict on the text of a problem", "[axioms]") {
  const std::string program = GENERATE("z3", "cvc5");
  if (answer(program, "(set-logic QF_UF)(check-sat)").empty()) {
    WARN(program + " is not installed");
    return;
  }
  const AxiomSet axioms = AxiomSet::shipped(AxiomSet::optional_names());
  std::map<Verdict, int> times;
  for (const auto& [trace, visits] :
       std::map<std::string, std::size_t>{{"eight-crossings", 5}, {"square-three-laps", 5}}) {
    const auto candidates = facts_of_candidates(trace, visits);
    for (const std::vector<Fact>& facts : candidates) {
      const Verdict ours = verdict(axioms, facts);
      ++times[ours];
      CHECK(answer(program, smt2_text(axioms, facts, trace)) ==
            (ours == Verdict::consistent ? "sat\n" : "unsat\n"));
    }
  }
  CHECK(times[Verdict::consistent] >= 3);
  CHECK(times[Verdict::inconsistent] >= 30);
}

TEST_CASE("other solvers read the shipped axioms", "[axioms]") {
  const std::string program = GENERATE("z3", "cvc5");
  if (answer(program, "(set-logic QF_UF)(check-sat)").empty()) {
    WARN(program + " is not installed");
    return;
  }
  // Declarations first; without the preference, since z3 knows no list as the value of set-info.
  std::string declarations = "(set-logic UF)\n";
  std::string assertions;
  for (const auto& [name, text] : AxiomSet::built_in_files()) {
    if (name == "preference.smt2") continue;
    std::string rest = text;
    for (std::size_t at; (at = rest.find("(assert")) != std::string::npos;) {
      const std::size_t end = rest.find("))\n", rest.find(":named ", at)) + 2;
      assertions += rest.substr(at, end - at) + "\n";
      rest.erase(at, end - at);
    }
    declarations += rest;
  }
  CHECK(answer(program, declarations + assertions) == "");
  CHECK(answer(program, declarations + "(assert (leads travel))").find("error") !=
        std::string::npos);
}

}  // namespace asterism
