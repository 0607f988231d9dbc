#include "core/topological_map.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <stdexcept>

namespace asterism {
namespace {

using Segments = std::map<PlaceArm, PlaceArm>;  ///< gateway to gateway, both ways

PlaceArm opposite(const TopologicalMap& map, PlaceArm arm) {
  return {arm.place, map.places[arm.place.index()].star.opposite(arm.arm)};
}

/// Follows the path out along `arm` to its end: an arm without segment. There is none where the
/// path closes on itself, be it on `arm` or, where a gateway leads to two, further on.
std::optional<PlaceArm> end_of_path(const TopologicalMap& map, const Segments& linked,
                                    PlaceArm arm) {
  for (std::size_t steps = 0; steps <= linked.size(); ++steps) {
    const auto next = linked.find(arm);
    if (next == linked.end()) return arm;
    arm = opposite(map, next->second);
  }
  return std::nullopt;
}

TopologicalMap::Path follow(const TopologicalMap& map, const Segments& linked, PlaceArm arm,
                            std::set<PlaceArm>& seen) {
  const auto one = end_of_path(map, linked, arm);
  const auto other = end_of_path(map, linked, opposite(map, arm));
  TopologicalMap::Path path;
  if (one && other) path.ends = {std::min(*one, *other), std::max(*one, *other)};
  PlaceArm forward = path.ends.empty() ? arm : opposite(map, path.ends.front());
  while (seen.insert(forward).second) {
    seen.insert(opposite(map, forward));
    path.places.push_back(forward.place);
    const auto next = linked.find(forward);
    if (next == linked.end()) break;
    forward = opposite(map, next->second);
  }
  return path;
}

}  // namespace

std::size_t left_arm(const Visit& visit, const Star& star, std::size_t entered) {
  const std::size_t size = visit.star.size();
  const std::size_t steps = (*visit.left_by + size - *visit.entered_by) % size;
  return star.clockwise(entered, steps);
}

TopologicalMap make_map(const Trace& trace, std::span<const Arrival> arrivals) {
  TopologicalMap map;
  Segments linked;
  std::set<TopologicalMap::Segment> segments;
  std::optional<PlaceArm> came_from;
  for (std::size_t k = 0; k < arrivals.size(); ++k) {
    const Visit& visit = trace.visits.at(k);
    const auto& [place, entered] = arrivals[k];
    if (place.index() > map.places.size())
      throw std::invalid_argument("places are not numbered by first visit");
    if (place.index() == map.places.size()) map.places.push_back({visit.star, VisitId(k)});
    const Star& star = map.places[place.index()].star;
    if (entered && *entered >= star.size()) throw std::invalid_argument("no such arm");

    map.visits.push_back(place);
    map.entered.push_back(entered);
    if (came_from) {
      const PlaceArm reached{place, entered.value()};
      segments.insert(std::minmax(*came_from, reached));
      linked.insert({*came_from, reached});
      linked.insert({reached, *came_from});
    }
    came_from.reset();
    if (visit.left_by) {
      // A first visit that was not entered is at its own place: arms are those of its own star.
      const std::size_t arm =
          entered && visit.entered_by ? left_arm(visit, star, *entered) : *visit.left_by;
      map.left.push_back(arm);
      came_from = PlaceArm{place, arm};
    } else {
      map.left.push_back(std::nullopt);
    }
  }
  map.segments.assign(segments.begin(), segments.end());

  std::set<PlaceArm> seen;
  for (std::size_t p = 0; p < map.places.size(); ++p)
    for (std::size_t arm = 0; arm < map.places[p].star.size(); ++arm)
      if (const PlaceArm first{PlaceId(p), arm}; !seen.contains(first))
        map.paths.push_back(follow(map, linked, first, seen));
  return map;
}

std::vector<std::array<std::size_t, 2>> pieces_of(const TopologicalMap& map) {
  std::vector<std::array<std::size_t, 2>> result;
  for (std::size_t k = 0; k < map.visits.size(); ++k) {
    if (k == 0 || !map.left[k - 1]) result.push_back({k, k});
    result.back()[1] = k;
  }
  return result;
}

std::vector<Arrival> arrivals(const TopologicalMap& map) {
  std::vector<Arrival> result;
  for (std::size_t k = 0; k < map.visits.size(); ++k)
    result.push_back({map.visits[k], map.entered[k]});
  return result;
}

}  // namespace asterism
