#include "engine/proof/crossing_map.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <span>

namespace asterism {
namespace {

using Segment = TopologicalMap::Segment;

std::set<PlaceId> piece_with(PlaceId start, const std::set<Segment>& segments) {
  std::set<PlaceId> piece{start};
  for (std::size_t size = 0; size != piece.size();) {
    size = piece.size();
    for (const auto& [one, other] : segments)
      if (piece.contains(one.place) || piece.contains(other.place))
        piece.insert({one.place, other.place});
  }
  return piece;
}

}  // namespace

CrossingMap crossing_map(const Trace& trace, const PartialMap& map, const Crossing& crossing) {
  const auto places = sketch_of(trace, std::span(map).first(crossing.visit.index() + 1)).map.places;
  const Segment last(std::minmax(crossing.left, crossing.entered));
  std::set<Segment> segments(crossing.segments.begin(), crossing.segments.end());
  segments.erase(last);
  const std::set<PlaceId> piece = piece_with(crossing.left.place, segments);

  CrossingMap result;
  std::map<PlaceId, PlaceId> number;
  for (const PlaceId place : piece) {
    number.emplace(place, PlaceId(result.names.size()));
    result.names.push_back(place);
    result.map.places.push_back(places.at(place.index()));
  }
  const auto renumbered = [&](PlaceArm arm) { return PlaceArm{number.at(arm.place), arm.arm}; };
  const auto add = [&](const Segment& one) {
    const PlaceArm begin = renumbered(one.first);
    const PlaceArm end = renumbered(one.second);
    result.map.segments.emplace_back(std::minmax(begin, end));
  };
  for (const Segment& one : segments)
    if (piece.contains(one.first.place)) add(one);
  add(last);

  for (std::size_t k = 0; k <= crossing.visit.index(); ++k)
    if (map[k] && piece.contains(map[k]->place))
      result.visits.emplace_back(VisitId(k), number.at(map[k]->place));
  for (const auto& loop : crossing.loops) {
    result.loops.emplace_back();
    for (const PlaceId place : loop) result.loops.back().push_back(number.at(place));
  }
  return result;
}

}  // namespace asterism
