#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/assumption.hpp"
#include "engine/arm_table.hpp"
#include "engine/tree/native_engine.hpp"

namespace asterism {

/// An engine whose children hold what is assumed too: one that breaks an assumption is dropped as
/// soon as both visits are there. Around an engine, so that one without assumptions pays nothing.
template <class E>
class Assuming {
 public:
  static constexpr std::uint64_t children_between_questions = E::children_between_questions;

  Assuming(E& engine, const ArmTable& table, std::span<const Assumption> assumptions)
      : engine_(engine), table_(table), assumptions_(assumptions) {}

  void reset(const Stop& stop) {
    engine_.reset(stop);
    place_.assign(table_.visits(), VisitId(0));
    decided_at_.assign(table_.visits(), {});
    for (const Assumption& assumption : assumptions_)
      if (const VisitId later = std::max(assumption.one, assumption.other);
          later.index() < table_.visits())
        decided_at_[later].push_back(assumption);
  }

  template <class F>
  void for_each_child(VisitId k, F&& f) {
    engine_.for_each_child(k, [&](ArmId arm, auto step) {
      if (is_allowed(k, arm)) f(arm, step);
    });
  }
  Step step(VisitId k, ArmId arm) const { return engine_.step(k, arm); }

  /// Visits that follow without a choice can break an assumption too: there the branch ends.
  ForcedRun follow(VisitId k, ArmId arm, Step step) {
    const ForcedRun run = engine_.follow(k, arm, step);
    for (const VisitId visit : IdRange(k.next(), run.end))
      if (!is_allowed(visit, engine_.arrived(visit))) return {visit, false};
    return run;
  }
  ArmId arrived(VisitId k) const { return engine_.arrived(k); }

  void enter(VisitId k, ArmId arm, Step step) {
    place_[k] = table_.visit_of(arm);
    engine_.enter(k, arm, step);
  }
  void leave(VisitId k, ArmId arm, Step step) { engine_.leave(k, arm, step); }
  auto extents_after(VisitId k, ArmId arm, Step step) const {
    return engine_.extents_after(k, arm, step);
  }

 private:
  /// Whether visit k may come in by this arm, the visits before being where they are.
  bool is_allowed(VisitId k, ArmId arm) {
    place_[k] = table_.visit_of(arm);
    return std::ranges::all_of(decided_at_[k], [&](const Assumption& assumption) {
      return agrees(assumption, place_[assumption.one], place_[assumption.other]);
    });
  }

  E& engine_;
  const ArmTable& table_;
  std::span<const Assumption> assumptions_;
  IdVector<VisitId, VisitId> place_;                       ///< by the visit it was first seen at
  IdVector<VisitId, std::vector<Assumption>> decided_at_;  ///< those whose later visit it is
};

}  // namespace asterism
