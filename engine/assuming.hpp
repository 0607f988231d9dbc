#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/assumption.hpp"
#include "engine/arm_table.hpp"
#include "engine/native.hpp"

namespace asterism {

/// An engine whose children hold what is assumed too: one that breaks an assumption is dropped as
/// soon as both visits are there. Around an engine, so that one without assumptions pays nothing.
template <class E>
class Assuming {
 public:
  Assuming(E& engine, const ArmTable& table, std::span<const Assumption> assumptions)
      : engine_(engine), table_(table), assumptions_(assumptions) {}

  void reset() {
    engine_.reset();
    place_.assign(table_.visits(), 0);
    decided_at_.assign(table_.visits(), {});
    for (const Assumption& assumption : assumptions_)
      if (const VisitId later = std::max(assumption.one, assumption.other);
          later.index() < table_.visits())
        decided_at_[later.index()].push_back(assumption);
  }

  template <class F>
  void for_each_child(std::size_t k, F&& f) {
    engine_.for_each_child(k, [&](ArmIndex arm, auto step) {
      if (is_allowed(k, arm)) f(arm, step);
    });
  }
  Step step(std::size_t k, ArmIndex arm) const { return engine_.step(k, arm); }

  /// Visits that follow without a choice can break an assumption too: there the branch ends.
  NativeEngine::Run follow(std::size_t k, ArmIndex arm, Step step) {
    const NativeEngine::Run run = engine_.follow(k, arm, step);
    for (std::size_t visit = k + 1; visit < run.end; ++visit)
      if (!is_allowed(visit, engine_.arrived(visit))) return {visit, false};
    return run;
  }
  ArmIndex arrived(std::size_t k) const { return engine_.arrived(k); }

  void enter(std::size_t k, ArmIndex arm, Step step) {
    place_[k] = table_.visit_of(arm);
    engine_.enter(k, arm, step);
  }
  void leave(std::size_t k, ArmIndex arm, Step step) { engine_.leave(k, arm, step); }
  Extents extents_after(std::size_t k, ArmIndex arm, Step step) const {
    return engine_.extents_after(k, arm, step);
  }

 private:
  /// Whether visit k may come in by this arm, the visits before being where they are.
  bool is_allowed(std::size_t k, ArmIndex arm) {
    place_[k] = table_.visit_of(arm);
    return std::ranges::all_of(decided_at_[k], [&](const Assumption& assumption) {
      return agrees(assumption, place_[assumption.one.index()], place_[assumption.other.index()]);
    });
  }

  E& engine_;
  const ArmTable& table_;
  std::span<const Assumption> assumptions_;
  std::vector<ArmIndex> place_;  ///< of visit k, by the visit it was first seen at
  std::vector<std::vector<Assumption>> decided_at_;  ///< those whose later visit is k
};

}  // namespace asterism
