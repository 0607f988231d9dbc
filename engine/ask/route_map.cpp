#include "engine/ask/route_map.hpp"

#include <algorithm>

namespace asterism {

void RouteMap::set(std::span<const Arrival> arrivals) {
  arrived_ = table_->named(arrivals);
  leads_to_.assign(table_->size(), no_arm);
  // As make_map has it where axioms of one's own let a gateway lead to two: the first counts.
  const auto link = [&](ArmId from, ArmId to) {
    if (leads_to_[from] == no_arm) leads_to_[from] = to;
  };
  for (const VisitId k : IdRange(VisitId(1), VisitId(arrived_.size()))) {
    const ArmId left = table_->left(k.previous(), arrived(k.previous()));
    link(left, arrived(k));
    link(arrived(k), left);
  }
}

bool RouteMap::leads(VisitId from, VisitId to, std::span<const std::size_t> route) const {
  ArmId arm = arrived(from);
  for (const std::size_t turn : route) {
    const auto next = after(arm, turn);
    if (!next) return false;
    arm = *next;
  }
  return place(arm) == place(arrived(to));
}

std::optional<Turns> RouteMap::shortest(VisitId from, VisitId to) const {
  // Breadth-first, the least turn first: each place is first come to by the first of its shortest
  // routes, and where one goes on from there hangs on no arm.
  struct Reached {
    ArmId arm;
    std::size_t before;
    std::size_t turn;
  };
  std::vector<Reached> reached{{arrived(from), 0, 0}};
  IdVector<VisitId, bool> is_reached(table_->visits());
  is_reached[place(arrived(from))] = true;
  const VisitId goal = place(arrived(to));
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const ArmId arm = reached[i].arm;
    if (place(arm) == goal) return turns_to(reached, i);
    for (std::size_t turn = 0; turn < turns(arm); ++turn) {
      const auto next = after(arm, turn);
      if (!next || is_reached[place(*next)]) continue;
      is_reached[place(*next)] = true;
      reached.push_back({*next, i, turn});
    }
  }
  return std::nullopt;
}

IdVector<VisitId, std::size_t> RouteMap::travels_to(VisitId visit) const {
  IdVector<VisitId, std::size_t> travels(table_->visits(), far);
  travels[place(arrived(visit))] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (const ArmId arm : table_->all_arms()) {
      if (leads_to_[arm] == no_arm) continue;
      const std::size_t by_travel = travels[place(leads_to_[arm])] + 1;
      if (by_travel >= std::min(travels[place(arm)], far)) continue;
      travels[place(arm)] = by_travel;
      changed = true;
    }
  }
  return travels;
}

}  // namespace asterism
