#pragma once

#include <cstddef>
#include <vector>

#include "axioms/axiom_solver.hpp"
#include "axioms/fact.hpp"
#include "core/stop.hpp"
#include "core/verdict.hpp"
#include "engine/proof/certify.hpp"

namespace asterism {

/// Puts a map to a fresh solver, step by step.
/// @param facts_of  facts_of(k) is what step k adds
template <class FactsOf>
Verdict check_model(const AxiomSet& axioms, const std::vector<Fact>& general, std::size_t steps,
                    Deadline deadline, FactsOf facts_of) {
  AxiomSolver solver(axioms, milliseconds_until(deadline));
  solver.add(general);
  for (std::size_t k = 0; k < steps; ++k) {
    if (is_over(deadline)) return Verdict::undecided;
    solver.add(facts_of(k));
  }
  return solver.check();
}

/// What comes of models that are each as is_model(model) says, if a map preferred to them is there
/// as exists_preferred() says. Asks no further than it must.
template <class Models, class IsModel, class ExistsPreferred>
Certificate certificate_of(const Models& models, IsModel is_model,
                           ExistsPreferred exists_preferred) {
  for (const auto& model : models)
    if (const Verdict verdict = is_model(model); verdict != Verdict::consistent)
      return verdict == Verdict::inconsistent ? Certificate::refuted : Certificate::not_shown;
  switch (exists_preferred()) {
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
