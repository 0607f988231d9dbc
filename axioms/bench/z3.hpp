#pragma once

#include <z3++.h>

#include <string>

#include "core/error.hpp"
#include "core/verdict.hpp"

namespace asterism {

// The bench: what all that ask Z3 share. Nothing of it is installed, so that users see no Z3.
//
//   z3.hpp              a solver as we want it, and what its answers mean
//   formula.hpp         a formula of an axiom, written for Z3
//   ground_terms.hpp    ground atoms and instances, written for Z3
//   guarded.hpp         which of many formulas cannot be together, and a second look at that
//   spare.hpp           leaving out one by one what can be spared
//   lazy_grounding.hpp  solve, ground the axioms on the solution, solve again

/// Calls f. Every use of Z3 goes through here, so that its exceptions end in one place.
/// @throws SolverError if Z3 fails, SolverMemoryError for want of memory
template <class F>
auto guarded_z3(F&& f) {
  try {
    return f();
  } catch (const z3::exception& error) {
    const std::string message = std::string("z3: ") + error.msg();
    if (message.find("out of memory") != std::string::npos) throw SolverMemoryError(message);
    throw SolverError(message);
  }
}

/// What an answer of Z3 means; "unknown" is *undecided*.
inline Verdict verdict_of(z3::check_result result) {
  return result == z3::sat     ? Verdict::consistent
         : result == z3::unsat ? Verdict::inconsistent
                               : Verdict::undecided;
}

/// Sets a parameter of a solver.
template <class Value>
void set_parameter(z3::solver& solver, const char* name, Value value) {
  z3::params parameters(solver.ctx());
  parameters.set(name, value);
  solver.set(parameters);
}

/// Leaves interrupts to the program: Z3 would take each for the end of one question.
inline void ignore_interrupts(z3::solver& solver) { set_parameter(solver, "ctrl_c", false); }

/// A solver for many short questions without quantifiers, which leaves interrupts to the program.
inline z3::solver simple_solver(z3::context& context) {
  z3::solver solver(context, z3::solver::simple());
  ignore_interrupts(solver);
  return solver;
}

/// Limits each question from now on.
inline void set_timeout(z3::solver& solver, unsigned timeout_ms) {
  set_parameter(solver, "timeout", timeout_ms);
}

}  // namespace asterism
