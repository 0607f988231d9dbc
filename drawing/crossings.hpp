#pragma once

#include <vector>

#include "core/map_drawing.hpp"
#include "core/topological_map.hpp"

namespace asterism {

/// Is this a plane drawing of the map? No two segments, arms or places meet but where they must, no
/// segment meets itself, each leaves along its arm, and arms leave in the clockwise order of their
/// stars. Exact for coordinates that are small multiples of a power of two.
bool is_plane(const TopologicalMap& map, const MapDrawing& drawing);

/// Lines from one point: do they meet nowhere else?
bool meet_only_at_start(const std::vector<MapDrawing::Polyline>& lines);

}  // namespace asterism
