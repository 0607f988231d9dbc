#pragma once

#include <utility>
#include <vector>

#include "core/topological_map.hpp"
#include "core/trace.hpp"
#include "engine/proof/explain.hpp"

namespace asterism {

/// As much of a partial map as it takes to show a travel that cannot be drawn: the connected piece
/// with that travel, as known when it ends.
struct CrossingMap {
  TopologicalMap map;          ///< places, and segments: last that of the travel; nothing else
  std::vector<PlaceId> names;  ///< what the partial map calls each place
  std::vector<std::pair<VisitId, PlaceId>> visits;  ///< up to the travel's end; places of `map`
  std::vector<std::vector<PlaceId>> loops;          ///< those of the crossing; places of `map`
};

/// @pre  crossing is that of the map: find_crossing()
CrossingMap crossing_map(const Trace& trace, const PartialMap& map, const Crossing& crossing);

}  // namespace asterism
