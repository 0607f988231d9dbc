#pragma once

#include <string>

#include "core/driven_way.hpp"
#include "core/topological_map.hpp"

namespace asterism {

/// A map's places and the ways driven as OpenStreetMap has it, to draw on with JOSM: a node a
/// place, a way a segment, tagged `highway=corridor`, `indoor=yes` and `width` in metres. What is
/// asterism's own begins so: `asterism:place`, `asterism:star`, `asterism:path`,
/// `asterism:length`. The file says that it is not to be uploaded.
///
/// The layout's frame lies at latitude and longitude 0, its metres those of the projection that
/// JOSM draws (EPSG:3857): x is to the east, y to the north.
///
/// @throws std::invalid_argument unless there is a finite pose a place and a way a segment
std::string map_osm(const TopologicalMap& map, const DrivenWays& ways);

}  // namespace asterism
