#include "engine/ask/query_map.hpp"

#include <algorithm>

namespace asterism {

QueryMap::QueryMap(const Trace& trace) : table_(trace) {
  left_.resize(table_.visits(), no_arm);
  linked_.resize(table_.size(), no_arm);
  path_of_arm_.resize(table_.size());
}

void QueryMap::set(std::span<const Arrival> arrivals) {
  arrivals_ = arrivals;
  has_links_ = has_paths_ = false;
}

std::size_t QueryMap::places() const {
  std::size_t places = 0;
  for (const Arrival& arrival : arrivals_) places = std::max(places, arrival.place.index() + 1);
  return places;
}

bool QueryMap::adjacent(PlaceId one, PlaceId other) const {
  for (std::size_t k = 1; k < arrivals_.size(); ++k) {
    const PlaceId from = arrivals_[k - 1].place;
    const PlaceId to = arrivals_[k].place;
    if ((from == one && to == other) || (from == other && to == one)) return true;
  }
  return false;
}

std::size_t QueryMap::steps(PlaceId from, PlaceId to) {
  // Relaxes the segments as they were travelled, there and back, until nothing changes: the trace
  // is one walk along all of them, so a few rounds do.
  steps_.assign(arrivals_.size(), none);
  steps_[from.index()] = 0;
  bool changed = true;
  const auto relax = [&](PlaceId near, PlaceId far) {
    const std::size_t by_near = steps_[near.index()];
    if (by_near == none || by_near + 1 >= steps_[far.index()]) return;
    steps_[far.index()] = by_near + 1;
    changed = true;
  };
  while (changed) {
    changed = false;
    for (std::size_t k = 1; k < arrivals_.size(); ++k) {
      relax(arrivals_[k - 1].place, arrivals_[k].place);
      relax(arrivals_[k].place, arrivals_[k - 1].place);
    }
    for (std::size_t k = arrivals_.size(); --k > 0;) {
      relax(arrivals_[k - 1].place, arrivals_[k].place);
      relax(arrivals_[k].place, arrivals_[k - 1].place);
    }
  }
  return steps_[to.index()];
}

void QueryMap::link() {
  if (has_links_) return;
  has_links_ = true;
  first_visit_ = {};
  segments_.clear();
  for (const VisitId k : IdRange<VisitId>(arrivals_.size())) {
    const auto& [place, entered] = arrivals_[k.index()];
    if (place.index() == first_visit_.size()) {
      first_visit_.push_back(k);
      for (const ArmId arm : table_.arms(k)) linked_[arm] = no_arm;
    }
    const ArmId reached = table_.arm(first_visit_[place], entered.value_or(0));
    left_[k] = table_.left(k, reached);
    if (k.index() == 0) continue;
    // As make_map has it where axioms of one's own let a gateway lead to two: the first counts.
    const ArmId from = left_[k.previous()];
    segments_.push_back(std::minmax(from, reached));
    if (linked_[from] == no_arm) linked_[from] = reached;
    if (linked_[reached] == no_arm) linked_[reached] = from;
  }
  std::sort(segments_.begin(), segments_.end());
  segments_.erase(std::unique(segments_.begin(), segments_.end()), segments_.end());
}

std::size_t QueryMap::segments() {
  link();
  return segments_.size();
}

std::optional<ArmId> QueryMap::end_of_path(ArmId arm) const {
  for (std::size_t steps = 0; steps <= 2 * segments_.size(); ++steps) {
    if (linked_[arm] == no_arm) return arm;
    arm = table_.opposite(linked_[arm]);
  }
  return std::nullopt;
}

void QueryMap::write_path(ArmId arm) {
  const std::size_t path = paths_.size();
  const auto one = end_of_path(arm);
  const auto other = end_of_path(table_.opposite(arm));
  const bool is_closed = !one || !other;
  const std::size_t first = places_of_paths_.size();
  ArmId forward = is_closed ? arm : table_.opposite(std::min(*one, *other));
  while (path_of_arm_[forward] == none) {
    path_of_arm_[forward] = path;
    if (std::size_t& back = path_of_arm_[table_.opposite(forward)]; back == none) back = path;
    places_of_paths_.push_back(arrivals_[table_.visit_of(forward).index()].place);
    if (linked_[forward] == no_arm) break;
    forward = table_.opposite(linked_[forward]);
  }
  paths_.push_back({first, places_of_paths_.size(), is_closed});
}

void QueryMap::write_paths() {
  if (has_paths_) return;
  link();
  has_paths_ = true;
  paths_.clear();
  places_of_paths_.clear();
  const auto for_each_arm = [&](auto f) {
    for (const VisitId visit : first_visit_)
      for (const ArmId arm : table_.arms(visit)) f(arm);
  };
  for_each_arm([&](ArmId arm) { path_of_arm_[arm] = none; });
  for_each_arm([&](ArmId arm) {
    if (path_of_arm_[arm] == none) write_path(arm);
  });
}

std::size_t QueryMap::paths() {
  write_paths();
  return paths_.size();
}

PathId QueryMap::path_of(VisitId visit) {
  write_paths();
  return PathId(path_of_arm_[left_[visit]]);
}

std::span<const PlaceId> QueryMap::places_of(PathId path) {
  write_paths();
  const Path& found = paths_[path.index()];
  return std::span(places_of_paths_).subspan(found.first, found.end - found.first);
}

bool QueryMap::is_closed(PathId path) {
  write_paths();
  return paths_[path.index()].is_closed;
}

}  // namespace asterism
