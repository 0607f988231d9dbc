#include "engine/ssh/ssh_closure.hpp"

#include <algorithm>

namespace asterism {

void SshClosure::add_dstate() {
  const auto dstate = static_cast<DState>(size());
  travel_.push_back(none);
  around_.push_back(none);
  place_.push_back(dstate);
  members_.resize(members_.size() + words_, 0);
  before_.resize(before_.size() + words_, 0);
  members_[dstate * words_ + dstate / 64] |= Word{1} << (dstate % 64);
}

std::optional<SshClosure::DState> SshClosure::result(DState q, ActionNumber action) const {
  DState known = none;
  if (action == SshTable::travel) known = travel_[q];
  if (action == SshTable::turn_around) known = around_[q];
  for (const auto& [from, turn, to] : turns_)
    if (from == q && turn == action) known = to;
  if (known == none) return std::nullopt;
  return known;
}

bool SshClosure::add_result(DState q, ActionNumber action, DState r) {
  if (const auto known = result(q, action)) return *known == r;  // deterministic
  bool holds = true;
  if (action == SshTable::travel) {
    holds = add_travel(q, r);
  } else if (action == SshTable::turn_around) {
    holds = join_places(q, r) && add_turn_around(q, r);
  } else {
    turns_.push_back({q, action, r});
    holds = join_places(q, r);
  }
  return holds && derive() && (!optional_.one_segment || keeps_one_segment()) &&
         (!optional_.one_crossing || keeps_one_crossing());
}

/// turn (2), and irreflexive (8) of what is now at one place.
bool SshClosure::join_places(DState q, DState r) {
  const DState keep = place_[q];
  const DState drop = place_[r];
  if (keep == drop) return true;
  for (DState d = 0; d < size(); ++d) {
    if (place_[d] != keep && place_[d] != drop) continue;
    const DState other = place_[d] == keep ? drop : keep;
    for (std::size_t w = 0; w < words_; ++w)
      if ((before_[d * words_ + w] & members_[other * words_ + w]) != 0) return false;
  }
  for (std::size_t w = 0; w < words_; ++w)
    members_[keep * words_ + w] |= members_[drop * words_ + w];
  std::ranges::replace(place_, drop, keep);
  return true;
}

/// What was travelled or ordered before is now known the other way round, too.
bool SshClosure::add_turn_around(DState q, DState r) {
  around_[q] = r;
  for (DState s = 0; s < size(); ++s) {
    if (travel_[s] != none && (s == q || travel_[s] == q)) turn_round(true, s, travel_[s]);
    if (is_before(q, s)) turn_round(false, q, s);
    if (is_before(s, q)) turn_round(false, s, q);
  }
  return true;
}

bool SshClosure::add_travel(DState q, DState r) {
  if (travel_[q] != none) return travel_[q] == r;  // deterministic
  travel_[q] = r;
  turn_round(true, q, r);
  agenda_.push_back({false, q, r});  // order (6)
  return true;
}

/// Adds an order with all that follows by transitive (10), and opposite (9) of each.
bool SshClosure::add_order(DState q, DState r) {
  if (is_before(q, r)) return true;
  for (DState s = 0; s < size(); ++s) {
    if (s != q && !is_before(s, q)) continue;
    for (DState t = 0; t < size(); ++t) {
      if ((t != r && !is_before(r, t)) || is_before(s, t)) continue;
      if (place_[s] == place_[t]) return false;  // irreflexive (8)
      before_[s * words_ + t / 64] |= Word{1} << (t % 64);
      turn_round(false, s, t);
    }
  }
  return true;
}

/// reversible, opposite (9): what leads from q to r, leads back where both can be turned around.
void SshClosure::turn_round(bool is_travel, DState q, DState r) {
  if (around_[q] != none && around_[r] != none)
    agenda_.push_back({is_travel, around_[r], around_[q]});
}

bool SshClosure::derive() {
  while (!agenda_.empty()) {
    const auto [is_travel, q, r] = agenda_.back();
    agenda_.pop_back();
    if (!(is_travel ? add_travel(q, r) : add_order(q, r))) return false;
  }
  return true;
}

bool SshClosure::keeps_one_segment() const {
  for (DState q = 0; q < size(); ++q)
    for (DState s = q + 1; s < size(); ++s)
      if (travel_[q] != none && travel_[s] != none && place_[q] == place_[s] &&
          place_[travel_[q]] == place_[travel_[s]])
        return false;
  return true;
}

bool SshClosure::keeps_one_crossing() const {
  for (DState q = 0; q < size(); ++q)
    for (DState s = q + 1; s < size(); ++s) {
      if (place_[q] != place_[s]) continue;
      for (DState r = 0; r < size(); ++r)
        for (DState t = 0; t < size(); ++t)
          if (is_before(q, r) && is_before(s, t) && place_[r] == place_[t]) return false;
    }
  return true;
}

}  // namespace asterism
