#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "axioms/axiom_set.hpp"
#include "axioms/fact.hpp"
#include "core/verdict.hpp"

namespace asterism {

/// Are these facts consistent with the axioms? Facts come and go as on a stack; Z3 decides.
/// For one thread at a time; each has a Z3 context of its own.
class AxiomSolver {
 public:
  /// @param timeout_ms  for each check; past it the answer is *undecided*
  AxiomSolver(const AxiomSet& axioms, unsigned timeout_ms);
  ~AxiomSolver();
  AxiomSolver(AxiomSolver&&) noexcept;
  AxiomSolver& operator=(AxiomSolver&&) noexcept;

  /// Marks the facts there are.
  void push();
  /// Takes back the facts added since the last mark, and that mark.
  void pop();
  /// Adds facts with all instances of the axioms that they complete.
  void add(std::span<const Fact> facts);
  /// Whether all facts there are can be.
  /// @throws SolverError if Z3 fails
  Verdict check();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Gives the solver so many bytes more than it holds, in all of this process, from now on. What
/// needs more throws SolverMemoryError, or kills the process: Z3 cannot always go on from there.
void limit_solver_memory(std::uint64_t bytes);

/// The version of Z3 that this was built with: "4.8.12.0".
std::string solver_version();

}  // namespace asterism
