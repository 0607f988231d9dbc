#include "engine/native.hpp"

#include <algorithm>

namespace asterism {

void NativeEngine::reset() {
  const std::size_t arms = table_.size();
  words_ = (table_.visits() + 63) / 64;
  extents_ = {};
  left_.assign(table_.visits(), none);
  travelled_.assign(table_.visits(), false);
  linked_.assign(arms, none);
  far_end_.assign(arms, none);
  places_.assign(arms * words_, 0);
  open_next_.resize(arms + table_.views());
  for (std::size_t i = 0; i < open_next_.size(); ++i) open_next_[i] = static_cast<ArmIndex>(i);
  open_previous_ = open_next_;
  if (options_.planar) faces_.reset(arms);
}

void NativeEngine::enter(std::size_t k, ArmIndex arm) {
  const ArmIndex x = k > 0 ? left_[k - 1] : none;
  left_[k] = table_.left(k, arm);
  travelled_[k] = k > 0 && linked_[x] == none;
  if (table_.visit_of(arm) == k) open_place(k, arm);
  if (!travelled_[k]) return;
  if (options_.planar) {
    if (table_.visit_of(arm) == k)
      faces_.replace(x, scratch_);
    else
      faces_.close(x, arm);
  }
  link(x, arm);
}

void NativeEngine::leave(std::size_t k, ArmIndex arm) {
  if (travelled_[k]) {
    const ArmIndex x = left_[k - 1];
    unlink(x, arm);
    if (options_.planar) {
      if (table_.visit_of(arm) == k)
        faces_.undo_replace(x);
      else
        faces_.undo_close(x, arm);
    }
  }
  if (table_.visit_of(arm) == k) close_place(k);
}

/// A new place: every local-path is a path of its own, every gateway open. Leaves in scratch_ the
/// gateways clockwise after the one entered by, without it.
void NativeEngine::open_place(std::size_t k, ArmIndex entered) {
  const ArmIndex first = table_.first_arm(k);
  const ArmIndex size = table_.star_size(k);
  for (ArmIndex arm = first; arm < first + size; ++arm) {
    far_end_[arm] = table_.opposite(arm);
    std::uint64_t* const places = &places_[arm * words_];
    std::fill_n(places, words_, 0);
    places[k / 64] = std::uint64_t{1} << (k % 64);
    if (table_.has_gateway(arm)) list_last(arm);
  }
  if (options_.planar) {
    scratch_.clear();
    for (ArmIndex step = 1; step < size; ++step)
      if (const ArmIndex arm = table_.clockwise(entered, step); table_.has_gateway(arm))
        scratch_.push_back(arm);
    if (k == 0) {
      if (table_.has_gateway(entered)) scratch_.push_back(entered);
      faces_.open(scratch_);
    }
  }
  ++extents_.places;
  extents_.paths += size / 2;
}

void NativeEngine::close_place(std::size_t k) {
  const ArmIndex first = table_.first_arm(k);
  for (ArmIndex arm = first + table_.star_size(k); arm-- > first;)
    if (table_.has_gateway(arm)) unlist(arm);
  --extents_.places;
  extents_.paths -= table_.star_size(k) / 2;
}

/// A segment joins the paths that end in x and in y into one, ending at their far ends.
void NativeEngine::link(ArmIndex x, ArmIndex y) {
  linked_[x] = y;
  linked_[y] = x;
  unlist(x);
  unlist(y);
  const ArmIndex a = far_end_[x];
  const ArmIndex b = far_end_[y];
  far_end_[a] = b;
  far_end_[b] = a;
  for (std::size_t w = 0; w < words_; ++w)
    places_[a * words_ + w] = places_[b * words_ + w] =
        places_[x * words_ + w] | places_[y * words_ + w];
  --extents_.paths;
  ++extents_.segments;
}

void NativeEngine::unlink(ArmIndex x, ArmIndex y) {
  linked_[x] = linked_[y] = none;
  relist(y);
  relist(x);
  // x and y still know their own paths.
  const ArmIndex a = far_end_[x];
  const ArmIndex b = far_end_[y];
  far_end_[a] = x;
  far_end_[b] = y;
  for (std::size_t w = 0; w < words_; ++w) {
    places_[a * words_ + w] = places_[x * words_ + w];
    places_[b * words_ + w] = places_[y * words_ + w];
  }
  ++extents_.paths;
  --extents_.segments;
}

void NativeEngine::list_last(ArmIndex gateway) {
  const ArmIndex end = head(table_.view(gateway));
  open_next_[gateway] = end;
  open_previous_[gateway] = open_previous_[end];
  relist(gateway);
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
