#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axioms/axiom_solver.hpp"
#include "core/stop.hpp"
#include "engine/ssh/ssh_closure.hpp"
#include "engine/ssh/ssh_table.hpp"
#include "engine/tree/both_engines.hpp"
#include "engine/tree/forced_run.hpp"

namespace asterism {

// Engines for a GrowingTree that chooses, for each view, the dstate it was seen at. The number
// after that of the last dstate is a new dstate; whether it is one is the step.

/// Decides by SshClosure.
class SshNative {
 public:
  using Choice = DStateId;
  static constexpr std::uint64_t children_between_questions = 1 << 12;

  SshNative(const SshTable& table, SshClosure::OptionalAxioms optional)
      : table_(table), empty_(table.views(), optional), levels_(table.views(), empty_) {}

  void reset(const Stop& stop);
  /// A known result leaves no choice. Else each dstate with the same view is put to the closure.
  template <class F>
  void for_each_child(VisitId k, F&& f) {
    const std::uint32_t seen = table_.view(k.index());
    if (const auto known = known_result(k)) {
      if (views_[known->index()] == seen && holds(k, *known)) f(*known, false);
      return;
    }
    for (DStateId dstate(0); dstate.index() < views_.size(); ++dstate)
      if (views_[dstate.index()] == seen && holds(k, dstate)) f(dstate, false);
    const DStateId next(views_.size());
    if (holds(k, next)) f(next, true);
  }
  bool step(VisitId k, DStateId dstate);
  ForcedRun follow(VisitId k, DStateId, bool) const { return {k.next(), true}; }
  DStateId arrived(VisitId k) const { return named_[k.index()]; }
  void enter(VisitId k, DStateId dstate, bool is_new);
  void leave(VisitId k, DStateId dstate, bool is_new);
  std::uint64_t undecided() const { return 0; }
  std::span<const DStateId> named() const { return named_; }

 private:
  std::optional<DStateId> known_result(VisitId k) const;
  bool holds(VisitId k, DStateId dstate);

  const SshTable& table_;
  SshClosure empty_;
  std::vector<SshClosure> levels_;  ///< after each view; those not reached are scratch
  std::vector<DStateId> named_;
  std::vector<std::uint32_t> views_;  ///< of each dstate
};

/// Z3 over the axiom files alone decides every candidate: each dstate, and a new one.  [theory §8]
class SshSolver {
 public:
  using Choice = DStateId;
  static constexpr std::uint64_t children_between_questions = 16;

  /// @param table, axioms  must outlive it
  SshSolver(const SshTable& table, const AxiomSet& axioms) : table_(table), axioms_(axioms) {}

  void reset(const Stop& stop);
  template <class F>
  void for_each_child(VisitId k, F&& f) {
    for (const DStateId dstate : candidates(k))
      if (decide(dstate) != Verdict::inconsistent) f(dstate, step(k, dstate));
  }
  bool step(VisitId k, DStateId dstate) const { return dstate == candidates(k).back(); }
  ForcedRun follow(VisitId k, DStateId, bool) const { return {k.next(), true}; }
  DStateId arrived(VisitId k) const { return named_[k.index()]; }
  void enter(VisitId k, DStateId dstate, bool is_new);
  void leave(VisitId k, DStateId dstate, bool is_new);

  std::vector<DStateId> candidates(VisitId k) const;
  Verdict decide(DStateId dstate);
  /// A candidate of view k in words.
  std::string words(VisitId k, DStateId dstate) const;
  /// What was experienced up to view k.
  Experience up_to(VisitId k) const;
  std::uint64_t undecided() const { return undecided_; }
  std::span<const DStateId> named() const { return named_; }

 private:
  const SshTable& table_;
  const AxiomSet& axioms_;
  std::optional<AxiomSolver> solver_;
  std::vector<DStateId> named_;
  std::uint64_t undecided_ = 0;
};

using SshBoth = BothEngines<SshNative, SshSolver>;

}  // namespace asterism
