#include "engine/proof/sketch.hpp"

#include <algorithm>
#include <set>

namespace asterism {

Sketch sketch_of(const Trace& trace, std::span<const std::optional<Arrival>> map) {
  Sketch sketch;
  std::set<TopologicalMap::Segment> segments;
  for (std::size_t k = 0; k < map.size(); ++k) {
    sketch.last.reset();
    if (!map[k]) continue;
    if (map[k]->place.index() == sketch.map.places.size())
      sketch.map.places.push_back({trace.visits[k].star, VisitId(k)});
    if (k == 0 || !map[k - 1]) continue;
    const Visit& before = trace.visits[k - 1];
    const Star& star = sketch.map.places[map[k - 1]->place.index()].star;
    const std::size_t left =
        map[k - 1]->entered ? left_arm(before, star, *map[k - 1]->entered) : *before.left_by;
    const PlaceArm from{map[k - 1]->place, left};
    const PlaceArm to{map[k]->place, *map[k]->entered};
    if (segments.insert(std::minmax(from, to)).second) sketch.last = {from, to};
  }
  sketch.map.segments.assign(segments.begin(), segments.end());
  return sketch;
}

}  // namespace asterism
