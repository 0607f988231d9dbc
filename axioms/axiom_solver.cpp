#include "axioms/axiom_solver.hpp"

#include "axioms/bench/ground_terms.hpp"
#include "axioms/bench/z3.hpp"
#include "axioms/grounder.hpp"

namespace asterism {

struct AxiomSolver::State {
  State(const AxiomSet& axioms, unsigned timeout_ms)
      : solver(simple_solver(context)), grounder(axioms), terms(context, grounder) {
    set_timeout(solver, timeout_ms);
  }

  z3::context context;
  z3::solver solver;
  Grounder grounder;
  Z3GroundTerms terms;
};

AxiomSolver::AxiomSolver(const AxiomSet& axioms, unsigned timeout_ms)
    : state_(guarded_z3([&] { return std::make_unique<State>(axioms, timeout_ms); })) {}
AxiomSolver::~AxiomSolver() = default;
AxiomSolver::AxiomSolver(AxiomSolver&&) noexcept = default;
AxiomSolver& AxiomSolver::operator=(AxiomSolver&&) noexcept = default;

void AxiomSolver::push() {
  guarded_z3([&] { state_->solver.push(); });
  state_->grounder.push();
}

void AxiomSolver::pop() {
  state_->grounder.pop();
  guarded_z3([&] { state_->solver.pop(); });
}

void AxiomSolver::add(std::span<const Fact> facts) {
  guarded_z3([&] {
    for (const Fact& fact : facts) {
      state_->solver.add(state_->terms.atom(state_->grounder.atom(fact)));
      state_->grounder.add(fact, [&](const Grounder::Instance& instance) {
        state_->solver.add(state_->terms.instance(instance));
      });
    }
  });
}

Verdict AxiomSolver::check() {
  return guarded_z3([&] { return verdict_of(state_->solver.check()); });
}

void limit_solver_memory(std::uint64_t bytes) {
  constexpr std::uint64_t megabyte = std::uint64_t{1} << 20;
  const std::uint64_t most = Z3_get_estimated_alloc_size() + bytes;
  z3::set_param("memory_max_size", std::to_string(most / megabyte).c_str());
}

std::string solver_version() { return Z3_get_full_version(); }

}  // namespace asterism
