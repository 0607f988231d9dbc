#pragma once

#include <z3++.h>

#include <functional>
#include <set>
#include <span>
#include <vector>

#include "axioms/bench/ground_terms.hpp"
#include "axioms/grounder.hpp"
#include "core/stop.hpp"
#include "core/verdict.hpp"

namespace asterism {

/// Axioms that a solver is told as far as its solutions break them: it solves, the axioms are
/// grounded on what the solution says, their instances are added, and it solves again. When there
/// is nothing new to add, the solution satisfies all axioms.
class LazyGrounding {
 public:
  /// @param guards  one for each of the axioms, whose instances hold where it does; none: they hold
  LazyGrounding(const AxiomSet& axioms, z3::context& context, z3::solver& solver,
                std::vector<z3::expr> guards = {});

  /// The axioms that are grounded.
  const AxiomSet& axioms() const { return grounder_.axioms(); }

  /// Says for good that facts hold where `choice` does, with the instances they lead to.
  void add(std::span<const Fact> facts, const z3::expr& choice);

  /// Asks until a solution stands.
  /// @param breaks  whether the solution that the solver has just found breaks something, which has
  ///                been added for the next time
  Verdict solve(const z3::expr_vector& assumptions, Deadline deadline,
                const std::function<bool()>& breaks);

  /// A fact that a solution stands for, because it makes these two choices.
  struct FoundFact {
    Fact fact;
    z3::expr one_choice;
    z3::expr other_choice;
  };

  /// Grounds the axioms on the facts of a solution, in order, and adds what is new of them and of
  /// instances. Stops when out of time, as if there were more to say.
  /// @param counts  whether new instances of an axiom, by its number, break the solution; by
  /// default
  ///                those of all do
  /// @return  whether anything breaks it
  bool refutes(std::span<const FoundFact> facts, Deadline deadline,
               const std::function<bool(std::size_t)>& counts = {});

 private:
  std::size_t number_of(const Axiom& axiom) const {
    return static_cast<std::size_t>(&axiom - axioms().axioms().data());
  }
  bool add_new(const z3::expr& formula);
  bool add_new(const Grounder::Instance& instance);

  z3::solver& solver_;
  Grounder grounder_;
  Z3GroundTerms terms_;
  std::vector<z3::expr> guards_;
  std::set<unsigned> added_;    ///< ids of formulas, valid while those are kept
  std::vector<z3::expr> kept_;  ///< the formulas that ids stand for
};

}  // namespace asterism
