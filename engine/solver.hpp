#pragma once

#include <vector>

#include "axioms/axiom_solver.hpp"
#include "engine/arm_table.hpp"
#include "engine/map_tree.hpp"
#include "engine/native.hpp"

namespace asterism {

/// Z3 over the axiom files alone decides every candidate: every arm of every place, and a new
/// place, no star matching first. Planarity is no axiom: what Z3 accepts is put to the Euler count.
///                                                                             [DESIGN §8]
class SolverEngine {
 public:
  SolverEngine(const ArmTable& table, const AxiomSet& axioms, bool planar, unsigned timeout_ms)
      : table_(table),
        axioms_(axioms),
        planar_(planar),
        timeout_ms_(timeout_ms),
        solver_(axioms, timeout_ms) {}

  void reset();

  /// Calls f(arm) for each candidate that is not refuted, in the order of arms, the new place last.
  template <class F>
  void for_each_child(std::size_t k, F&& f) {
    for (const ArmIndex arm : candidates(k))
      if (decide(arm) != Verdict::inconsistent) f(arm, step(k, arm));
  }
  Step step(std::size_t k, ArmIndex arm) const {
    return table_.visit_of(arm) == k ? Step::new_place : Step::closure;  // whatever Z3 makes of it
  }
  /// Never further than the visit itself: Z3 is to say what follows.
  NativeEngine::Run follow(std::size_t k, ArmIndex, Step) const { return {k + 1, true}; }
  ArmIndex arrived(std::size_t) const { return 0; }
  void enter(std::size_t k, ArmIndex arm, Step step);
  void leave(std::size_t k, ArmIndex arm, Step step);
  Extents extents_after(std::size_t k, ArmIndex arm, Step step) const;

  std::vector<ArmIndex> candidates(std::size_t k) const;
  Verdict decide(ArmIndex arm);
  std::uint64_t undecided() const { return undecided_; }
  std::span<const ArmIndex> named() const { return named_; }

 private:
  TopologicalMap map_with(ArmIndex arm) const;

  const ArmTable& table_;
  const AxiomSet& axioms_;
  bool planar_;
  unsigned timeout_ms_;
  AxiomSolver solver_;
  std::vector<ArmIndex> named_;
  std::uint64_t undecided_ = 0;
};

/// Native engine and solver side by side, compared at every candidate.
class BothEngines {
 public:
  BothEngines(NativeEngine native, SolverEngine solver, const ArmTable& table)
      : native_(std::move(native)), solver_(std::move(solver)), table_(table) {}

  void reset() {
    native_.reset();
    solver_.reset();
  }
  template <class F>
  void for_each_child(std::size_t k, F&& f) {
    std::vector<ArmIndex> children;
    native_.for_each_child(k, [&](ArmIndex arm, Step) { children.push_back(arm); });
    compare(k, children);
    for (const ArmIndex arm : children) f(arm, native_.step(k, arm));
  }
  Step step(std::size_t k, ArmIndex arm) const { return native_.step(k, arm); }
  NativeEngine::Run follow(std::size_t k, ArmIndex, Step) const { return {k + 1, true}; }
  ArmIndex arrived(std::size_t) const { return 0; }
  void enter(std::size_t k, ArmIndex arm, Step step) {
    native_.enter(k, arm, step);
    solver_.enter(k, arm, step);
  }
  void leave(std::size_t k, ArmIndex arm, Step step) {
    solver_.leave(k, arm, step);
    native_.leave(k, arm, step);
  }
  Extents extents_after(std::size_t k, ArmIndex arm, Step step) const {
    return native_.extents_after(k, arm, step);
  }
  std::uint64_t undecided() const { return solver_.undecided(); }

 private:
  /// @throws DifferenceError if the solver would keep other children
  void compare(std::size_t k, std::vector<ArmIndex> native_children);

  NativeEngine native_;
  SolverEngine solver_;
  const ArmTable& table_;
};

}  // namespace asterism
