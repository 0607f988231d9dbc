#include "tests/support/brute_force.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace asterism {
namespace {

using Matching = std::map<PlaceArm, PlaceArm>;  ///< gateway to gateway, both ways

/// What a data association says, written out.
struct Candidate {
  std::vector<const Star*> stars;  ///< of each place, as listed at its first visit
  Matching across;
};

std::size_t opposite(const Star& star, std::size_t arm) {
  for (std::size_t i = 0; i < star.size(); ++i)
    if (i != arm && star.arm(i).label == star.arm(arm).label) return i;
  return arm;
}

PlaceArm opposite(const Candidate& map, PlaceArm arm) {
  return {arm.place, opposite(*map.stars[arm.place.index()], arm.arm)};
}

/// Whether one star read clockwise from arm i equals another read from arm j, up to labels and
/// signs.                                                                         [theory §3]
bool match(const Star& one, std::size_t i, const Star& other, std::size_t j) {
  const std::size_t size = one.size();
  if (other.size() != size) return false;
  for (std::size_t s = 0; s < size; ++s) {
    const Arm& a = one.arm((i + s) % size);
    const Arm& b = other.arm((j + s) % size);
    if (a.has_gateway != b.has_gateway) return false;
    for (std::size_t t = 0; t < size; ++t) {
      const bool one_paired = a.label == one.arm((i + t) % size).label;
      const bool other_paired = b.label == other.arm((j + t) % size).label;
      if (one_paired != other_paired) return false;
    }
  }
  return true;
}

/// The gateway a visit left by, an arm of its place.
PlaceArm departure(const Visit& visit, const Arrival& arrival) {
  // A first visit that does not say how it was entered is told in the arms of its own star.
  if (!visit.entered_by || !arrival.entered) return {arrival.place, *visit.left_by};
  std::size_t seen = *visit.entered_by;
  std::size_t arm = *arrival.entered;
  while (seen != *visit.left_by) {
    seen = (seen + 1) % visit.star.size();
    arm = (arm + 1) % visit.star.size();
  }
  return {arrival.place, arm};
}

/// Writes the association out; nothing if a star does not match or a gateway would lead to two.
std::optional<Candidate> candidate(const Trace& trace, const Association& association) {
  Candidate map;
  for (std::size_t k = 0; k < association.size(); ++k) {
    const auto& [place, entered] = association[k];
    const Visit& visit = trace.visits[k];
    if (place.index() == map.stars.size()) map.stars.push_back(&visit.star);
    if (k == 0) continue;
    const Star& star = *map.stars[place.index()];
    if (!match(visit.star, *visit.entered_by, star, *entered)) return std::nullopt;
    const PlaceArm from = departure(trace.visits[k - 1], association[k - 1]);
    const PlaceArm to{place, *entered};
    if (!map.stars[from.place.index()]->arm(from.arm).has_gateway) return std::nullopt;
    if (!star.arm(to.arm).has_gateway) return std::nullopt;
    if (map.across.emplace(from, to).first->second != to) return std::nullopt;
    if (map.across.emplace(to, from).first->second != from) return std::nullopt;
  }
  return map;
}

/// Axiom (8): follows each path from each of its arms.
bool some_path_meets_a_place_twice(const Candidate& map) {
  for (const auto& [arm, reached] : map.across) {
    std::set<PlaceId> met{arm.place};
    for (auto next = map.across.find(arm); next != map.across.end();
         next = map.across.find(opposite(map, next->second)))
      if (!met.insert(next->second.place).second) return true;
  }
  return false;
}

/// Arrive by gateway h, go on by the next gateway clockwise after h that has a segment.
PlaceArm next_round_face(const Candidate& map, PlaceArm gateway) {
  PlaceArm on = map.across.at(gateway);
  const std::size_t size = map.stars[on.place.index()]->size();
  do {
    on.arm = (on.arm + 1) % size;
  } while (!map.across.contains(on));
  return on;
}

/// V - E + F = 2; a map without segments is planar.                              [theory §7]
bool is_planar(const Candidate& map) {
  std::size_t faces = 0;
  std::set<PlaceArm> seen;
  for (const auto& [gateway, reached] : map.across) {
    if (seen.contains(gateway)) continue;
    ++faces;
    for (PlaceArm at = gateway; seen.insert(at).second;) at = next_round_face(map, at);
  }
  const std::size_t segments = map.across.size() / 2;
  return segments == 0 || map.stars.size() + faces == segments + 2;
}

bool two_places_share_segments(const Candidate& map) {
  std::set<std::pair<PlaceId, PlaceId>> joined;
  for (const auto& [from, to] : map.across)
    if (from < to && !joined.insert(std::minmax(from.place, to.place)).second) return true;
  return false;
}

/// The places of the path through an arm, both ways.
std::set<PlaceId> places_of_path(const Candidate& map, PlaceArm arm) {
  std::set<PlaceId> met{arm.place};
  for (const PlaceArm start : {arm, opposite(map, arm)})
    for (auto next = map.across.find(start); next != map.across.end();
         next = map.across.find(opposite(map, next->second)))
      met.insert(next->second.place);
  return met;
}

/// @pre  no path meets a place twice
bool two_paths_meet_twice(const Candidate& map) {
  for (std::size_t p = 0; p < map.stars.size(); ++p)
    for (std::size_t i = 0; i < map.stars[p]->size(); ++i)
      for (std::size_t j = 0; j < map.stars[p]->size(); ++j) {
        if (j == i || j == opposite(*map.stars[p], i)) continue;
        const std::set<PlaceId> one = places_of_path(map, {PlaceId(p), i});
        const std::set<PlaceId> other = places_of_path(map, {PlaceId(p), j});
        for (const PlaceId place : one)
          if (place != PlaceId(p) && other.contains(place)) return true;
      }
  return false;
}

/// Every way to go on from an association to the next visit: any arm of any place, or a new place.
std::vector<Association> extensions(const Trace& trace, const Association& association) {
  const Visit& visit = trace.visits[association.size()];
  std::vector<std::size_t> arms;  ///< of each place
  for (std::size_t k = 0; k < association.size(); ++k)
    if (association[k].place.index() == arms.size()) arms.push_back(trace.visits[k].star.size());
  std::vector<Association> result;
  const auto add = [&](std::size_t place, std::optional<std::size_t> entered) {
    result.push_back(association);
    result.back().push_back({PlaceId(place), entered});
  };
  for (std::size_t place = 0; place < arms.size(); ++place)
    for (std::size_t arm = 0; arm < arms[place]; ++arm) add(place, arm);
  add(arms.size(), visit.entered_by);
  return result;
}

}  // namespace

bool is_consistent(const Trace& trace, const Association& association,
                   const BruteForceOptions& options) {
  const auto map = candidate(trace, association);
  if (!map || some_path_meets_a_place_twice(*map)) return false;
  if (options.planar && !is_planar(*map)) return false;
  if (options.one_segment && two_places_share_segments(*map)) return false;
  if (options.one_crossing && two_paths_meet_twice(*map)) return false;
  return true;
}

std::vector<Association> every_map(const Trace& trace, const BruteForceOptions& options) {
  std::vector<Association> open{{}};
  std::vector<Association> result;
  while (!open.empty()) {
    const Association association = open.back();
    open.pop_back();
    if (association.size() == trace.visits.size()) {
      if (is_consistent(trace, association, options)) result.push_back(association);
      continue;
    }
    for (auto& extended : extensions(trace, association)) open.push_back(std::move(extended));
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<std::vector<Association>> every_map_by_visit(const Trace& trace,
                                                         const BruteForceOptions& options) {
  std::vector<std::vector<Association>> levels;
  std::vector<Association> level{{}};
  while (levels.size() < trace.visits.size()) {
    std::vector<Association> next;
    for (const Association& association : level)
      for (auto& extended : extensions(trace, association))
        if (is_consistent(trace, extended, options)) next.push_back(std::move(extended));
    std::sort(next.begin(), next.end());
    levels.push_back(next);
    level = std::move(next);
  }
  return levels;
}

}  // namespace asterism
