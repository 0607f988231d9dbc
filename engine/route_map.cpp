#include "engine/route_map.hpp"

#include <algorithm>

namespace asterism {

void RouteMap::set(std::span<const Arrival> arrivals) {
  arrived_ = table_->named(arrivals);
  leads_to_.assign(table_->size(), no_arm);
  // As make_map has it where axioms of one's own let a gateway lead to two: the first counts.
  const auto link = [&](ArmIndex from, ArmIndex to) {
    if (leads_to_[from] == no_arm) leads_to_[from] = to;
  };
  for (std::size_t k = 1; k < arrived_.size(); ++k) {
    const ArmIndex left = table_->left(k - 1, arrived_[k - 1]);
    link(left, arrived_[k]);
    link(arrived_[k], left);
  }
}

bool RouteMap::leads(std::size_t from, std::size_t to, std::span<const std::size_t> route) const {
  ArmIndex arm = arrived_[from];
  for (const std::size_t turn : route) {
    const auto next = after(arm, turn);
    if (!next) return false;
    arm = *next;
  }
  return place(arm) == place(arrived_[to]);
}

std::optional<Turns> RouteMap::shortest(std::size_t from, std::size_t to) const {
  // Breadth-first, the least turn first: each place is first come to by the first of its shortest
  // routes, and where one goes on from there hangs on no arm.
  struct Reached {
    ArmIndex arm;
    std::size_t before;
    std::size_t turn;
  };
  std::vector<Reached> reached{{arrived_[from], 0, 0}};
  std::vector<bool> is_reached(table_->visits());
  is_reached[place(arrived_[from])] = true;
  const std::size_t goal = place(arrived_[to]);
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const ArmIndex arm = reached[i].arm;
    if (place(arm) == goal) {
      Turns route;
      for (std::size_t back = i; back > 0; back = reached[back].before)
        route.push_back(reached[back].turn);
      std::ranges::reverse(route);
      return route;
    }
    for (std::size_t turn = 0; turn < turns(arm); ++turn) {
      const auto next = after(arm, turn);
      if (!next || is_reached[place(*next)]) continue;
      is_reached[place(*next)] = true;
      reached.push_back({*next, i, turn});
    }
  }
  return std::nullopt;
}

std::vector<std::size_t> RouteMap::travels_to(std::size_t visit) const {
  std::vector<std::size_t> travels(table_->visits(), far);
  travels[place(arrived_[visit])] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (ArmIndex arm = 0; arm < leads_to_.size(); ++arm) {
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
