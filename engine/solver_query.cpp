#include "engine/solver_query.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace asterism {
namespace {

Claim::Count count_of(const std::string& extent) {
  return extent == "path"    ? Claim::Count::paths
         : extent == "place" ? Claim::Count::places
                             : Claim::Count::segments;
}

Claim compare(const std::string& extent, Claim::Relation relation, std::size_t size) {
  return {Claim::Comparison{count_of(extent), relation, std::uint64_t{size}}};
}

std::vector<Arrival> whole_map(const MapProblem& problem) {
  std::vector<Arrival> result;
  for (const std::optional<Arrival>& arrival : problem.map()) result.push_back(arrival.value());
  return result;
}

bool counts_paths_or_segments(const Claim& claim) {
  const auto counts = [](const Claim::Number& number) {
    const auto* count = std::get_if<Claim::Count>(&number);
    return count != nullptr && *count != Claim::Count::places;
  };
  if (const auto* all = std::get_if<Claim::All>(&claim.is))
    return std::ranges::any_of(all->parts, counts_paths_or_segments);
  if (const auto* any = std::get_if<Claim::Any>(&claim.is))
    return std::ranges::any_of(any->parts, counts_paths_or_segments);
  if (const auto* negation = std::get_if<Claim::Not>(&claim.is))
    return counts_paths_or_segments(negation->part.front());
  const auto* comparison = std::get_if<Claim::Comparison>(&claim.is);
  return comparison != nullptr && (counts(comparison->left) || counts(comparison->right));
}

}  // namespace

void require_countable(const Claim& claim, const std::string& text, const AxiomSet& axioms) {
  if (!counts_paths_or_segments(claim)) return;
  for (const char* name : {"deterministic", "reversible", "irreflexive", "transitive"})
    if (!axioms.contains(name))
      throw InputError(text, std::string("paths or segments counted without the axiom ") + name,
                       "a query that does not count them, or one by enumeration");
}

Claim preferred_to(const std::vector<std::size_t>& extents, const AxiomSet& axioms) {
  Claim::Any ways;
  for (std::size_t i = 0; i < extents.size(); ++i) {
    Claim::All way{{compare(axioms.preference()[i], Claim::Relation::less, extents[i])}};
    for (std::size_t j = 0; j < i; ++j)
      way.parts.push_back(compare(axioms.preference()[j], Claim::Relation::at_most, extents[j]));
    ways.parts.push_back({way});
  }
  return {ways};
}

std::vector<std::size_t> extents_by_preference(const TopologicalMap& map, const AxiomSet& axioms) {
  std::vector<std::size_t> result;
  for (const std::string& extent : axioms.preference())
    result.push_back(extent == "path"    ? map.paths.size()
                     : extent == "place" ? map.places.size()
                                         : map.segments.size());
  return result;
}

Optimum find_optimum(MapProblem& problem, const Trace& trace, const AxiomSet& axioms,
                     std::vector<Premise> premises) {
  Optimum best{problem.check(premises), {}, {}};
  while (best.verdict == Verdict::consistent) {
    best.map = whole_map(problem);
    best.extents = extents_by_preference(make_map(trace, best.map), axioms);
    std::vector<Premise> better = premises;
    better.push_back(problem.add(preferred_to(best.extents, axioms)));
    const Verdict verdict = problem.check(better);
    if (verdict == Verdict::inconsistent) break;
    if (verdict == Verdict::undecided) best.verdict = verdict;
  }
  return best;
}

std::optional<Modality> SolverAnswer::modality() const {
  if (can_hold == Verdict::inconsistent) return Modality::impossible;
  if (can_hold == Verdict::undecided || can_fail == Verdict::undecided) return std::nullopt;
  return can_fail == Verdict::inconsistent ? Modality::certain : Modality::possible;
}

std::vector<SolverAnswer> ask_solver(const Trace& trace, const AxiomSet& axioms, bool planar,
                                     std::span<const Claim> given, std::span<const Query> queries,
                                     bool only_minimal, double seconds) {
  for (const Query& query : queries) {
    require_visits(query, trace);
    require_countable(query.claim, query.text, axioms);
  }
  MapProblem problem(trace, axioms, seconds);
  std::vector<Premise> premises = problem.premises(planar);
  for (const Claim& claim : given) premises.push_back(problem.add(claim));
  Verdict verdict = Verdict::consistent;
  if (only_minimal) {
    const Optimum best = find_optimum(problem, trace, axioms, premises);
    verdict = best.verdict;
    // None is smaller, so that these are as large; and closed paths, which the solver counts as
    // none, cannot hide a map from it.
    for (std::size_t i = 0; i < best.extents.size(); ++i)
      premises.push_back(
          problem.add(compare(axioms.preference()[i], Claim::Relation::at_most, best.extents[i])));
  }
  const auto ask = [&](const Claim& claim, std::optional<std::vector<Arrival>>& map) {
    if (verdict != Verdict::consistent) return verdict;
    std::vector<Premise> with_claim = premises;
    with_claim.push_back(problem.add(claim));
    const Verdict answer = problem.check(with_claim);
    if (answer == Verdict::consistent) map = whole_map(problem);
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
