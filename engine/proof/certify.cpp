#include "engine/proof/certify.hpp"

#include <algorithm>
#include <stdexcept>

#include "engine/arm_table.hpp"
#include "engine/facts.hpp"
#include "engine/preference.hpp"
#include "engine/proof/certificate.hpp"
#include "engine/proof/map_problem.hpp"
#include "engine/proof/optimum.hpp"
#include "planarity/euler.hpp"

namespace asterism {
namespace {

Verdict exists_preferred(const Trace& trace, const Theory& theory,
                         const std::vector<std::size_t>& best, const Stop& stop) {
  MapProblem problem(trace, theory, stop);
  std::vector<Premise> premises = problem.premises();
  return check_preferred_to(best, problem, trace, theory.axioms, premises);
}

bool holds_assumptions(const Theory& theory, const TopologicalMap& map) {
  return std::ranges::all_of(theory.assumptions, [&](const Assumption& assumption) {
    return agrees(assumption, map.visits.at(assumption.one.index()),
                  map.visits.at(assumption.other.index()));
  });
}

}  // namespace

Certificate certify(const Trace& trace, const Theory& theory,
                    std::span<const std::vector<Arrival>> models, const Stop& stop) {
  if (models.empty()) throw std::invalid_argument("no models to certify");
  const AxiomSet& axioms = theory.axioms;
  const ArmTable table(trace);
  const auto best = extents_by_preference(trace, models.front(), axioms);
  const auto is_model = [&](const std::vector<Arrival>& model) {
    const TopologicalMap map = make_map(trace, model);
    if (extents_by_preference(trace, model, axioms) != best ||
        (theory.planar && part_not_planar(map)) || !holds_assumptions(theory, map))
      return Verdict::inconsistent;
    const std::vector<ArmId> named = table.named(model);
    return check_model(axioms, general_facts(), named.size(), stop.deadline, [&](std::size_t k) {
      return visit_facts(table, std::span(named).first(k + 1));
    });
  };
  return certificate_of(models, is_model,
                        [&] { return exists_preferred(trace, theory, best, stop); });
}

}  // namespace asterism
