#include "engine/certify.hpp"

#include <algorithm>
#include <stdexcept>

#include "axioms/axiom_solver.hpp"
#include "core/deadline.hpp"
#include "engine/arm_table.hpp"
#include "engine/facts.hpp"
#include "engine/map_problem.hpp"
#include "engine/solver_query.hpp"
#include "planarity/euler.hpp"

namespace asterism {
namespace {

Verdict check_model(const ArmTable& table, const AxiomSet& axioms, std::span<const ArmIndex> named,
                    Deadline deadline) {
  AxiomSolver solver(axioms, milliseconds_until(deadline));
  solver.add(general_facts());
  for (std::size_t k = 0; k < named.size(); ++k) {
    if (is_over(deadline)) return Verdict::undecided;
    solver.add(visit_facts(table, named.first(k + 1)));
  }
  return solver.check();
}

Verdict exists_preferred(const Trace& trace, const AxiomSet& axioms, bool planar,
                         std::span<const Assumption> assumptions,
                         const std::vector<std::size_t>& best, Deadline deadline) {
  MapProblem problem(trace, axioms, seconds_until(deadline));
  std::vector<Premise> premises = problem.premises(planar);
  for (const Assumption& assumption : assumptions)
    premises.push_back(problem.add(claim_of(assumption)));
  premises.push_back(problem.add(preferred_to(best, axioms)));
  return problem.check(premises);
}

}  // namespace

Certificate certify(const Trace& trace, const AxiomSet& axioms, bool planar,
                    std::span<const std::vector<Arrival>> models, double seconds,
                    std::span<const Assumption> assumptions) {
  const Deadline deadline = deadline_in(seconds);
  const ArmTable table(trace);

  std::optional<std::vector<std::size_t>> best;
  for (const auto& model : models) {
    const TopologicalMap map = make_map(trace, model);
    if (!best) best = extents_by_preference(map, axioms);
    const bool is_as_assumed = std::ranges::all_of(assumptions, [&](const Assumption& assumption) {
      return agrees(assumption, map.visits.at(assumption.one.index()),
                    map.visits.at(assumption.other.index()));
    });
    if (extents_by_preference(map, axioms) != *best || (planar && part_not_planar(map)) ||
        !is_as_assumed)
      return Certificate::refuted;
    switch (check_model(table, axioms, table.named(model), deadline)) {
      case Verdict::inconsistent:
        return Certificate::refuted;
      case Verdict::undecided:
        return Certificate::not_shown;
      case Verdict::consistent:
        break;
    }
  }
  if (!best) throw std::invalid_argument("no models to certify");
  switch (exists_preferred(trace, axioms, planar, assumptions, *best, deadline)) {
    case Verdict::inconsistent:
      return Certificate::shown;
    case Verdict::consistent:
      return Certificate::refuted;
    case Verdict::undecided:
      break;
  }
  return Certificate::not_shown;
}

}  // namespace asterism
