#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>

#include "axioms/axiom_solver.hpp"
#include "axioms/smt2_text.hpp"
#include "engine/facts.hpp"
#include "engine/tree/map_tree.hpp"
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
    std::vector<ArmId> named = table.named(arrivals);
    named.push_back(no_arm);
    for (const ArmId arm : table.all_arms()) {
      const VisitId visit = table.visit_of(arm);
      const bool is_new = visit.index() == visits - 1;
      if (is_new ? arm != table.entered(visit) : table.visit_of(named[visit.index()]) != visit)
        continue;
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
