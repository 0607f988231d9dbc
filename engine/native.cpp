#include "engine/native.hpp"

#include <algorithm>

namespace asterism {

void NativeEngine::reset() {
  const std::size_t arms = table_.size();
  words_ = (table_.visits() + 63) / 64;
  extents_ = {};
  arrived_.assign(table_.visits(), none);
  left_.assign(table_.visits(), none);
  linked_.assign(arms, none);
  far_end_.resize(arms);
  places_.assign(arms * words_, 0);
  for (ArmIndex arm = 0; arm < arms; ++arm) {
    const std::size_t place = table_.visit_of(arm);
    far_end_[arm] = table_.opposite(arm);
    places_[arm * words_ + place / 64] = std::uint64_t{1} << (place % 64);
  }
  open_.assign((arms + 63) / 64, 0);
  alike_.assign(open_.size() * table_.views(), 0);
  for (ArmIndex arm = 0; arm < arms; ++arm)
    alike_[table_.view(arm) * open_.size() + arm / 64] |= std::uint64_t{1} << (arm % 64);
  parts_.clear();
  first_part_.clear();
  for (std::size_t k = 0; k < table_.visits(); ++k) {
    first_part_.push_back(parts_.size());
    for (const ArmIndex gateway : table_.gateways(k)) {
      const std::size_t word = gateway / 64;
      if (parts_.size() == first_part_.back() || parts_.back().word != word)
        parts_.push_back({word, 0});
      parts_.back().gateways |= std::uint64_t{1} << (gateway % 64);
    }
  }
  first_part_.push_back(parts_.size());
  if (options_.planar) faces_.reset(arms);
}

bool NativeEngine::joined(ArmIndex place, ArmIndex other_place) const {
  const ArmIndex first = table_.first_arm(place);
  for (ArmIndex arm = first; arm < first + table_.star_size(place); ++arm)
    if (linked_[arm] != none && table_.visit_of(linked_[arm]) == other_place) return true;
  return false;
}

ArmIndex NativeEngine::end_of_path(ArmIndex arm) const {
  while (linked_[arm] != none) arm = table_.opposite(linked_[arm]);
  return arm;
}

/// Calls f for an end of each other path through each place of the path that ends in `end`.
template <class F>
void NativeEngine::for_each_crossing(ArmIndex end, F&& f) const {
  for (ArmIndex on_path = table_.opposite(end);; on_path = table_.opposite(linked_[on_path])) {
    const ArmIndex first = table_.first_arm(table_.visit_of(on_path));
    for (ArmIndex arm = first; arm < first + table_.star_size(table_.visit_of(on_path)); ++arm)
      if (arm < table_.opposite(arm) && arm != on_path && table_.opposite(arm) != on_path)
        f(end_of_path(arm));
    if (linked_[on_path] == none) return;
  }
}

/// Would joining the paths that end in x and in y make one that meets some other path twice? No
/// path does so yet: that other path meets both.
bool NativeEngine::crossed(ArmIndex x, ArmIndex y) const {
  bool found = false;
  for_each_crossing(x, [&](ArmIndex other) {
    for (std::size_t w = 0; w < words_; ++w)
      if (places_[other * words_ + w] & places_[y * words_ + w]) found = true;
  });
  return found;
}

}  // namespace asterism
