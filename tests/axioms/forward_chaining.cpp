#include "tests/axioms/forward_chaining.hpp"

namespace asterism {

ForwardChaining::ForwardChaining(std::span<const Fact> facts) {
  for (const auto& [relation, arguments] : facts) {
    if (relation == "leads") leads_.insert({arguments[0], arguments[1], arguments[2]});
    if (relation == "sees") sees_.insert({arguments[0], arguments[1]});
    if (relation == "is_turn") turns_.insert(arguments[0]);
    if (relation == "next") next_.insert({arguments[0], arguments[1]});
    if (relation == "opposite") opposite_.insert({arguments[0], arguments[1]});
    if (relation == "order") order_.insert({arguments[0], arguments[1]});
    if (relation == "ends") ends_.insert(arguments[0]);
  }
}

Verdict ForwardChaining::verdict() {
  while (derive()) continue;
  return is_contradictory() ? Verdict::inconsistent : Verdict::consistent;
}

ForwardChaining::DState ForwardChaining::place(DState dstate) const {
  for (auto on = places_.find(dstate); on != places_.end(); on = places_.find(dstate))
    dstate = on->second;
  return dstate;
}

/// One round; whether anything was new.
bool ForwardChaining::derive() {
  const std::size_t before = size();
  for (const auto& [q, r] : next_) leads_.insert({q, "turn_clockwise", r});   // star
  for (const auto& [q, r] : opposite_) leads_.insert({q, "turn_around", r});  // star_binding
  for (const auto& [q, r] : std::set(opposite_)) opposite_.insert({r, q});
  std::set<std::pair<DState, DState>> around;
  for (const auto& [q, action, r] : leads_) {
    if (action == "turn_around") around.insert({q, r});
    if (action == "travel") order_.insert({q, r});                                      // order (6)
    if (turns_.contains(action) && place(q) != place(r)) places_[place(q)] = place(r);  // turn (2)
  }
  const auto leads = leads_;
  const auto order = order_;
  for (const auto& [q, turned_q] : around)
    for (const auto& [r, turned_r] : around) {
      if (leads.contains({q, "travel", r}))
        leads_.insert({turned_r, "travel", turned_q});                  // reversible
      if (order.contains({q, r})) order_.insert({turned_r, turned_q});  // opposite (9)
    }
  for (const auto& [q, r] : order)
    for (const auto& [s, t] : order)
      if (r == s) order_.insert({q, t});  // transitive (10)
  return size() > before;
}

bool ForwardChaining::is_contradictory() const {
  for (const auto& [q, a, r] : leads_)
    for (const auto& [s, b, t] : leads_)
      if (q == s && a == b && r != t) return true;  // deterministic
  for (const auto& [q, v] : sees_)
    for (const auto& [r, w] : sees_)
      if (q == r && v != w) return true;  // view
  for (const auto& circle : {next_, opposite_})
    for (const auto& [q, r] : circle)
      for (const auto& [s, t] : circle)
        if ((q == s) != (r == t)) return true;  // star, star_binding
  for (const auto& [q, r] : order_)
    if (ends_.contains(q) || place(q) == place(r)) return true;  // path_end, irreflexive (8)
  return false;
}

}  // namespace asterism
