#include "engine/proof/optimum.hpp"

#include <cstdint>

#include "engine/preference.hpp"
#include "engine/proof/map_problem.hpp"

namespace asterism {
namespace {

/// "Preferred to a map of these extents": one is smaller, and those before it are no larger.
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

}  // namespace

Claim compare(Extent extent, Claim::Relation relation, std::size_t size) {
  return {Claim::Comparison{extent, relation, std::uint64_t{size}}};
}

Verdict check_for(MapProblem& problem, std::vector<Premise>& premises,
                  const std::function<bool(std::span<const Arrival>)>& is_wanted) {
  while (true) {
    const Verdict verdict = problem.check(premises);
    if (verdict != Verdict::consistent) return verdict;
    const std::vector<Arrival> map = problem.whole_map();
    if (is_wanted(map)) return verdict;
    premises.push_back(problem.exclude(map));
  }
}

Verdict check_preferred_to(const std::vector<std::size_t>& extents, MapProblem& problem,
                           const Trace& trace, const AxiomSet& axioms,
                           std::vector<Premise>& premises) {
  if (axioms.minimises_own())
    return check_for(problem, premises, [&](std::span<const Arrival> map) {
      return extents_by_preference(trace, map, axioms) < extents;
    });
  std::vector<Premise> better = premises;
  better.push_back(problem.add(preferred_to(extents, axioms)));
  return problem.check(better);
}

Optimum find_optimum(MapProblem& problem, const Trace& trace, const AxiomSet& axioms,
                     std::vector<Premise> premises) {
  Optimum best{problem.check(premises), {}, {}};
  while (best.verdict == Verdict::consistent) {
    best.map = problem.whole_map();
    best.extents = extents_by_preference(trace, best.map, axioms);
    const Verdict verdict = check_preferred_to(best.extents, problem, trace, axioms, premises);
    if (verdict == Verdict::inconsistent) break;
    if (verdict == Verdict::undecided) best.verdict = verdict;
  }
  return best;
}

}  // namespace asterism
