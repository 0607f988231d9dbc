#include "engine/tree/native_engine.hpp"

namespace asterism {

void NativeEngine::reset() {
  const std::size_t arms = table_.size();
  words_ = words_for(table_.visits());
  extents_ = {};
  arrived_.assign(table_.visits(), no_arm);
  left_.assign(table_.visits(), no_arm);
  linked_.assign(arms, no_arm);
  far_end_.assign(arms, no_arm);
  places_.assign(arms * words_, 0);
  open_.assign(words_for(arms), 0);
  alike_.assign(open_.size() * table_.views(), 0);
  for (const ArmId arm : table_.all_arms()) {
    const VisitId place = table_.visit_of(arm);
    far_end_[arm] = table_.opposite(arm);
    places(arm)[word_of(place)] = bit_of(place);
    alike_[table_.view(arm).index() * open_.size() + word_of(arm)] |= bit_of(arm);
  }
  parts_.clear();
  first_part_ = {};
  for (const VisitId k : table_.all_visits()) {
    first_part_.push_back(parts_.size());
    const std::size_t first = parts_.size();
    for (const ArmId gateway : table_.gateways(k)) {
      if (parts_.size() == first || parts_.back().word != word_of(gateway))
        parts_.push_back({word_of(gateway), 0});
      parts_.back().gateways |= bit_of(gateway);
    }
  }
  first_part_.push_back(parts_.size());
  if (rules_.faces) faces_.reset(arms);
}

bool NativeEngine::joined(VisitId place, VisitId other_place) const {
  for (const ArmId arm : table_.arms(place))
    if (linked_[arm] != no_arm && table_.visit_of(linked_[arm]) == other_place) return true;
  return false;
}

ArmId NativeEngine::end_of_path(ArmId arm) const {
  while (linked_[arm] != no_arm) arm = table_.opposite(linked_[arm]);
  return arm;
}

/// Calls f for an end of each other path through each place of the path that ends in `end`.
template <class F>
void NativeEngine::for_each_crossing(ArmId end, F&& f) const {
  for (ArmId on_path = table_.opposite(end);; on_path = table_.opposite(linked_[on_path])) {
    for (const ArmId arm : table_.arms(table_.visit_of(on_path)))
      if (arm < table_.opposite(arm) && arm != on_path && table_.opposite(arm) != on_path)
        f(end_of_path(arm));
    if (linked_[on_path] == no_arm) return;
  }
}

/// Would joining the paths that end in x and in y make one that meets some other path twice? No
/// path does so yet: that other path meets both.
bool NativeEngine::crossed(ArmId x, ArmId y) const {
  bool found = false;
  for_each_crossing(x, [&](ArmId other) { found = found || have_common_place(other, y); });
  return found;
}

}  // namespace asterism
