#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "axioms/axiom_solver.hpp"
#include "engine/tree/map_tree.hpp"
#include "tests/axioms/ground_problems.hpp"
#include "tests/support/axiom_files.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/known_traces.hpp"

// docs/axioms.md says what each axiom is there for. Here every row of it is found again.

namespace asterism {
namespace {

constexpr unsigned timeout_ms = 10'000;

std::string document() {
  std::ifstream stream(ASTERISM_SOURCE_DIR "/docs/axioms.md");
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// The rows of the table under a heading, each as written, and then their first cells.
std::vector<std::string> rows(const std::string& heading) {
  std::istringstream lines(document().substr(document().find("## " + heading)));
  std::vector<std::string> result;
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line) && !line.starts_with("## "))
    if (line.starts_with("| `")) result.push_back(line);
  return result;
}

std::vector<Fact> facts(const std::string& text) {
  std::vector<Fact> result;
  std::istringstream list(text);
  for (std::string atom; std::getline(list, atom, ',');) {
    std::istringstream words(atom);
    Fact& fact = result.emplace_back();
    words >> fact.relation;
    for (std::string word; words >> word;) fact.arguments.push_back(word);
  }
  return result;
}

/// Whether the axioms refute the facts; or, where there is a goal, entail it: with its negation
/// they refute them.
bool decides(AxiomFiles files, const GroundProblem& problem) {
  std::vector<Fact> given = facts(problem.facts);
  if (!problem.goal.empty()) {
    files["goal.smt2"] =
        "(declare-fun goal (DState DState) Bool)\n"
        "(assert (! (forall ((q DState) (r DState)) (=> (goal q r) (not " +
        problem.goal + "))) :named goal))\n";
    given.push_back({"goal", {problem.q, problem.r}});
  }
  AxiomSolver solver(AxiomSet::parse(files), timeout_ms);
  solver.add(given);
  const Verdict verdict = solver.check();
  REQUIRE(verdict != Verdict::undecided);
  return verdict == Verdict::inconsistent;
}

AxiomFiles files_with_optional(const std::string& axiom) {
  AxiomFiles files = shipped_files();
  const std::string file = "optional/" + axiom + ".smt2";
  const auto& built_in = AxiomSet::built_in_files();
  if (built_in.contains(file)) files[file] = built_in.at(file);
  return files;
}

struct Prefix {
  std::string trace;
  std::size_t visits;
};
const std::vector<Prefix> prefixes{
    {"eight-crossings", 14}, {"grid-4x4-snake", 11}, {"square-three-laps", 8}};
constexpr std::uint64_t most_hypotheses = 200;

std::string count(const Prefix& prefix, const AxiomFiles& files) {
  static const std::vector<KnownTrace> all = known_traces();
  const auto known = std::find_if(all.begin(), all.end(), [&](const KnownTrace& other) {
    return other.trace.name == prefix.trace;
  });
  MapTree tree({.theory = {.axioms = AxiomSet::parse(files)},
                .check = Check::solver,
                .max_hypotheses = most_hypotheses});
  const auto growth = tree.extend(std::span(known->trace.visits).first(prefix.visits));
  REQUIRE(tree.undecided() == 0);
  return growth == MapTree::Growth::complete ? std::to_string(tree.size())
                                             : "over " + std::to_string(most_hypotheses);
}

std::string counts(const AxiomFiles& files) {
  std::string result;
  for (const Prefix& prefix : prefixes) result += count(prefix, files) + " | ";
  return result;
}

std::string ground_cell(const GroundProblem& problem) {
  const std::string verb = problem.goal.empty() ? "refutes" : "entails `" + problem.goal + "` from";
  return verb + " `" + problem.facts + "`";
}

}  // namespace

TEST_CASE("each axiom alone decides a small problem, and some the counts", "[axioms][traces]") {
  const std::string whole = counts(shipped_files());
  std::vector<std::string> found{"| `(all)` | " + whole + "|"};
  const AxiomSet axioms = AxiomSet::shipped(AxiomSet::optional_names());
  for (const Axiom& axiom : axioms.axioms()) {
    INFO(axiom.name);
    if (axiom.by_signature) {
      found.push_back("| `" + axiom.name + "` | - | - | - | said by the signature |");
      continue;
    }
    const AxiomFiles with = files_with_optional(axiom.name);
    const AxiomFiles without = with_axiom(with, axiom.name);
    const bool is_optional = with.size() > shipped_files().size();
    const GroundProblem problem = only_decided_by(axiom.name);
    CHECK(decides(with, problem));
    CHECK_FALSE(decides(without, problem));
    found.push_back("| `" + axiom.name + "` | " + counts(is_optional ? with : without) +
                    ground_cell(problem) + " |");
  }
  const std::vector<std::string> told = rows("Left out");
  CHECK(found == told);
}

TEST_CASE("each part of an axiom decides a small problem, or follows from the others", "[axioms]") {
  std::vector<std::string> found;
  std::set<std::string> weakened_axioms;
  for (const Weakening& weakening : weakenings()) {
    INFO(weakening.axiom << ": " << weakening.formula);
    weakened_axioms.insert(weakening.axiom);
    const AxiomFiles full = files_with_optional(weakening.axiom);
    const AxiomFiles weak =
        with_axiom(full, weakening.axiom,
                   "(assert (! " + weakening.formula + " :named " + weakening.axiom + "))");
    std::string cell;
    if (weakening.premise.empty()) {
      CHECK(decides(full, weakening.problem));
      CHECK_FALSE(decides(weak, weakening.problem));
      cell = ground_cell(weakening.problem);
    } else {
      // The axiom follows if it cannot fail, whichever of its dstates are the same.
      for (const GroundProblem& failing : ways_to_fail(weakening)) {
        INFO(failing.facts);
        CHECK(decides(weak, failing));
      }
      cell = "nothing: the others imply it";
    }
    found.push_back("| `" + weakening.axiom + "` | " + weakening.lost + " | " + cell + " |");
  }
  const AxiomSet axioms = AxiomSet::shipped(AxiomSet::optional_names());
  for (const Axiom& axiom : axioms.axioms())
    CHECK((axiom.by_signature || weakened_axioms.contains(axiom.name)));
  const std::vector<std::string> told = rows("Weakened");
  CHECK(found == told);
}

}  // namespace asterism
