#include "planarity/euler.hpp"

#include <map>
#include <numeric>
#include <set>

namespace asterism {
namespace {

using Links = std::map<PlaceArm, PlaceArm>;  ///< gateway to gateway, both ways

Links links(const TopologicalMap& map) {
  Links linked;
  for (const auto& [one, other] : map.segments) {
    linked.insert({one, other});
    linked.insert({other, one});
  }
  return linked;
}

/// The next gateway clockwise after `arrived` that has a segment.
PlaceArm go_on(const TopologicalMap& map, const Links& linked, PlaceArm arrived) {
  const Star& star = map.places[arrived.place.index()].star;
  PlaceArm next = arrived;
  do next.arm = star.clockwise(next.arm, 1);
  while (!linked.contains(next));
  return next;
}

/// Pieces of the map that hold a segment.
std::size_t count_pieces(const TopologicalMap& map) {
  std::vector<std::size_t> piece(map.places.size());
  std::iota(piece.begin(), piece.end(), std::size_t{0});
  const auto root = [&](PlaceId place) {
    std::size_t p = place.index();
    while (piece[p] != p) p = piece[p];
    return p;
  };
  for (const auto& [one, other] : map.segments) piece[root(one.place)] = root(other.place);
  std::set<std::size_t> roots;
  for (const auto& [one, other] : map.segments) roots.insert(root(one.place));
  return roots.size();
}

}  // namespace

std::vector<std::vector<PlaceArm>> faces(const TopologicalMap& map) {
  const Links linked = links(map);
  std::vector<std::vector<PlaceArm>> result;
  std::set<PlaceArm> seen;
  for (const auto& [first, reached] : linked) {
    if (seen.contains(first)) continue;
    auto& face = result.emplace_back();
    for (PlaceArm gateway = first; seen.insert(gateway).second;
         gateway = go_on(map, linked, linked.at(gateway)))
      face.push_back(gateway);
  }
  return result;
}

bool is_planar(const TopologicalMap& map) {
  std::set<PlaceId> joined;
  for (const auto& [one, other] : map.segments) joined.insert({one.place, other.place});
  return joined.size() + faces(map).size() == map.segments.size() + 2 * count_pieces(map);
}

std::optional<TopologicalMap> part_not_planar(const TopologicalMap& map) {
  std::map<PlaceArm, std::size_t> segment_of;
  for (std::size_t s = 0; s < map.segments.size(); ++s) {
    const auto& [one, other] = map.segments[s];
    std::set<std::size_t> too_many;
    for (const PlaceArm gateway : {one, other})
      if (const auto [known, is_first] = segment_of.emplace(gateway, s); !is_first)
        too_many.insert({known->second, s});
    // Of two with one gateway, a part has one or none; of one that leads back into its own, none.
    for (const std::size_t spared : too_many) {
      TopologicalMap fewer = map;
      fewer.segments.erase(fewer.segments.begin() + static_cast<std::ptrdiff_t>(spared));
      if (auto part = part_not_planar(fewer)) return part;
    }
    if (!too_many.empty()) return std::nullopt;
  }
  return is_planar(map) ? std::nullopt : std::optional(map);
}

}  // namespace asterism
