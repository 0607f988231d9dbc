#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axioms/axiom_set.hpp"
#include "axioms/grounder.hpp"
#include "core/verdict.hpp"

namespace asterism {

/// Are these facts consistent with the axioms? Facts come and go as on a stack; Z3 decides.
class AxiomSolver {
 public:
  /// @param timeout_ms  for each check; past it the answer is *undecided*
  AxiomSolver(const AxiomSet& axioms, unsigned timeout_ms);
  ~AxiomSolver();
  AxiomSolver(AxiomSolver&&) noexcept;
  AxiomSolver& operator=(AxiomSolver&&) noexcept;

  void push();
  void pop();
  /// Adds facts with all instances of the axioms that they complete.
  void add(std::span<const Fact> facts);
  /// @throws SolverError if Z3 fails
  Verdict check();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Why facts contradict the axioms: facts and instances that together cannot be, none of which can
/// be spared.
struct Clash {
  struct Step {
    std::string axiom;
    std::vector<std::pair<std::string, std::string>> binding;  ///< variable, constant
  };
  std::vector<Step> steps;
  std::vector<Fact> facts;
};

/// The first `background` facts are taken for granted and not listed. Found by a fresh solver,
/// minimised, and checked again by another.
/// @return nothing if the facts are consistent, or the solver did not say
std::optional<Clash> find_clash(const AxiomSet& axioms, std::span<const Fact> facts,
                                std::size_t background, unsigned timeout_ms);

/// The problem as SMT-LIB 2 text without quantifiers, for any solver: declarations, unique names, a
/// named assertion a fact and an instance, check-sat.
std::string smt2_text(const AxiomSet& axioms, std::span<const Fact> facts,
                      const std::string& title);

}  // namespace asterism
