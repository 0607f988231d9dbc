#include "axioms/bench/lazy_grounding.hpp"

#include <utility>

#include "axioms/bench/z3.hpp"

namespace asterism {

LazyGrounding::LazyGrounding(const AxiomSet& axioms, z3::context& context, z3::solver& solver,
                             std::vector<z3::expr> guards)
    : solver_(solver), grounder_(axioms), terms_(context, grounder_), guards_(std::move(guards)) {}

void LazyGrounding::add(std::span<const Fact> facts, const z3::expr& choice) {
  for (const Fact& fact : facts) {
    solver_.add(z3::implies(choice, terms_.atom(grounder_.atom(fact))));
    grounder_.add(fact, [&](const Grounder::Instance& instance) { add_new(instance); });
  }
}

Verdict LazyGrounding::solve(const z3::expr_vector& assumptions, Deadline deadline,
                             const std::function<bool()>& breaks) {
  while (!is_over(deadline)) {
    set_timeout(solver_, milliseconds_until(deadline));
    const Verdict verdict = verdict_of(solver_.check(assumptions));
    if (verdict != Verdict::consistent || !breaks()) return verdict;
  }
  return Verdict::undecided;
}

bool LazyGrounding::refutes(std::span<const FoundFact> facts, Deadline deadline,
                            const std::function<bool(std::size_t)>& counts) {
  bool is_refuted = false;
  grounder_.push();
  for (const auto& [fact, one_choice, other_choice] : facts) {
    if (is_over(deadline)) {
      is_refuted = true;
      break;
    }
    is_refuted |=
        add_new(z3::implies(one_choice && other_choice, terms_.atom(grounder_.atom(fact))));
    grounder_.add(fact, [&](const Grounder::Instance& instance) {
      is_refuted |= add_new(instance) && (!counts || counts(number_of(*instance.axiom)));
    });
  }
  grounder_.pop();
  return is_refuted;
}

bool LazyGrounding::add_new(const Grounder::Instance& instance) {
  const z3::expr formula = terms_.instance(instance);
  return add_new(guards_.empty() ? formula
                                 : z3::implies(guards_[number_of(*instance.axiom)], formula));
}

bool LazyGrounding::add_new(const z3::expr& formula) {
  if (!added_.insert(formula.id()).second) return false;
  kept_.push_back(formula);
  solver_.add(formula);
  return true;
}

}  // namespace asterism
