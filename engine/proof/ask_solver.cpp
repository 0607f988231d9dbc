#include "engine/proof/ask_solver.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "engine/preference.hpp"
#include "engine/proof/map_problem.hpp"
#include "engine/proof/optimum.hpp"

namespace asterism {
namespace {

bool counts_paths_or_segments(const Claim& claim) {
  const auto counts = [](const Claim::Number& number) {
    const auto* count = std::get_if<Extent>(&number);
    return count != nullptr && *count != Extent::place;
  };
  return std::ranges::any_of(statements_of(claim), [&](const Statement& statement) {
    const auto* comparison = std::get_if<Claim::Comparison>(&statement.claim->is);
    return comparison != nullptr && (counts(comparison->left) || counts(comparison->right));
  });
}

}  // namespace

void require_countable(const Claim& claim, const std::string& text, const AxiomSet& axioms) {
  if (!counts_paths_or_segments(claim)) return;
  for (const char* name : {"deterministic", "reversible", "irreflexive", "transitive"})
    if (!axioms.contains(name))
      throw InputError(text, std::string("paths or segments counted without the axiom ") + name,
                       "a query that does not count them, or one by enumeration");
}

std::optional<Modality> SolverAnswer::modality() const {
  if (can_hold == Verdict::inconsistent) return Modality::impossible;
  if (can_hold == Verdict::undecided || can_fail == Verdict::undecided) return std::nullopt;
  return can_fail == Verdict::inconsistent ? Modality::certain : Modality::possible;
}

std::vector<SolverAnswer> ask_solver(const Trace& trace, const Theory& theory,
                                     std::span<const Query> queries, bool only_minimal,
                                     const Stop& stop) {
  const AxiomSet& axioms = theory.axioms;
  for (const Query& query : queries) {
    require_visits(query, trace);
    require_countable(query.claim, query.text, axioms);
  }
  MapProblem problem(trace, theory, stop);
  std::vector<Premise> premises = problem.premises();
  Verdict verdict = Verdict::consistent;
  const bool is_counted = only_minimal && axioms.minimises_own();
  std::vector<std::size_t> least;
  if (only_minimal) {
    const Optimum best = find_optimum(problem, trace, axioms, premises);
    verdict = best.verdict;
    least = best.extents;
    // None is smaller, so that these are as large; and closed paths, which the solver counts as
    // none, cannot hide a map from it.
    for (std::size_t i = 0; i < best.extents.size() && !is_counted; ++i)
      premises.push_back(
          problem.add(compare(axioms.preference()[i], Claim::Relation::at_most, best.extents[i])));
  }
  const auto ask = [&](const Claim& claim, std::optional<std::vector<Arrival>>& map) {
    if (verdict != Verdict::consistent) return verdict;
    std::vector<Premise> with_claim = premises;
    with_claim.push_back(problem.add(claim));
    const Verdict answer = check_for(problem, with_claim, [&](std::span<const Arrival> found) {
      return !is_counted || extents_by_preference(trace, found, axioms) == least;
    });
    if (answer == Verdict::consistent) map = problem.whole_map();
    return answer;
  };
  std::vector<SolverAnswer> answers;
  for (const Query& query : queries) {
    SolverAnswer& answer = answers.emplace_back();
    answer.can_hold = ask(query.claim, answer.witness);
    answer.can_fail = ask({Claim::Not{{query.claim}}}, answer.counterexample);
  }
  return answers;
}

}  // namespace asterism
