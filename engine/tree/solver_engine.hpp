#pragma once

#include <string>
#include <vector>

#include "axioms/axiom_solver.hpp"
#include "engine/arm_table.hpp"
#include "engine/tree/map_tree.hpp"
#include "engine/tree/native_engine.hpp"

namespace asterism {

/// Z3 over the axiom files alone decides every candidate: every arm of every place, and a new
/// place, no star matching first. Planarity is no axiom: what Z3 accepts is put to the Euler count.
///                                                                             [theory §8]
class SolverEngine {
 public:
  static constexpr std::uint64_t children_between_questions = 16;

  /// @param table, theory  must outlive it
  SolverEngine(const ArmTable& table, const Theory& theory) : table_(table), theory_(theory) {}

  /// Begins again with the empty hypothesis. Must be called before all else.
  void reset(const Stop& stop);

  /// Calls f(arm) for each candidate that is not refuted, in the order of arms, the new place last.
  template <class F>
  void for_each_child(VisitId k, F&& f) {
    for (const ArmId arm : candidates(k))
      if (decide(arm) != Verdict::inconsistent) f(arm, step(k, arm));
  }
  Step step(VisitId k, ArmId arm) const {
    return table_.visit_of(arm) == k ? Step::new_place : Step::closure;  // whatever Z3 makes of it
  }
  /// Never further than the visit itself: Z3 is to say what follows.
  ForcedRun follow(VisitId k, ArmId, Step) const { return {k.next(), true}; }
  ArmId arrived(VisitId) const { return no_arm; }
  void enter(VisitId k, ArmId arm, Step step);
  void leave(VisitId k, ArmId arm, Step step);
  /// Sizes of what the axioms minimise, in order of preference.
  std::vector<std::size_t> extents_after(VisitId k, ArmId arm, Step step) const;

  std::vector<ArmId> candidates(VisitId k) const;
  Verdict decide(ArmId arm);
  /// A candidate of visit k in words.
  std::string words(VisitId k, ArmId arm) const;
  /// The visits up to k.
  Trace up_to(VisitId k) const;
  std::uint64_t undecided() const { return undecided_; }
  std::span<const ArmId> named() const { return named_; }

 private:
  std::vector<ArmId> named_with(ArmId arm) const;

  const ArmTable& table_;
  const Theory& theory_;
  std::optional<AxiomSolver> solver_;
  std::vector<ArmId> named_;
  std::uint64_t undecided_ = 0;
};

}  // namespace asterism
