#pragma once

#include <z3++.h>

#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "axioms/grounder.hpp"
#include "core/error.hpp"

namespace asterism {

/// Calls f. Every use of Z3 goes through here, so that its exceptions end in one place.
/// @throws SolverError if Z3 fails
template <class F>
auto guarded_z3(F&& f) {
  try {
    return f();
  } catch (const z3::exception& error) {
    throw SolverError(std::string("z3: ") + error.msg());
  }
}

/// Leaves interrupts to the program: Z3 would take each for the end of one question.
void ignore_interrupts(z3::solver& solver);

/// One for many short questions without quantifiers.
inline z3::solver simple_solver(z3::context& context) {
  z3::solver solver(context, z3::solver::simple());
  ignore_interrupts(solver);
  return solver;
}

/// For each question from now on.
void set_timeout(z3::solver& solver, unsigned timeout_ms);

/// Ground atoms and instances as Z3 expressions.
class Z3Vocabulary {
 public:
  Z3Vocabulary(z3::context& context, Grounder& grounder);

  z3::expr term(Grounder::TermId id);
  z3::expr atom(const Grounder::GroundAtom& atom);
  /// premise → conclusion; equalities between constants named apart are decided.
  z3::expr instance(const Grounder::Instance& instance);

 private:
  z3::expr make_instance(const Grounder::Instance& instance);
  z3::expr formula(const Formula& formula, const Grounder::Instance& instance);
  z3::expr equality(Grounder::TermId a, Grounder::TermId b);

  z3::context& context_;
  Grounder& grounder_;
  std::map<std::string, z3::func_decl> functions_;
  std::vector<z3::func_decl> relations_;
  std::vector<z3::expr> terms_;
  struct KeyHash {
    std::size_t operator()(const std::vector<Grounder::TermId>& key) const;
  };
  std::map<const Axiom*, std::unordered_map<std::vector<Grounder::TermId>, z3::expr, KeyHash>>
      instances_;
};

}  // namespace asterism
