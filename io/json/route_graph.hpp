#pragma once

#include <string>

#include "core/driven_way.hpp"
#include "core/topological_map.hpp"

namespace asterism {

/// A map's places and the ways driven as a graph of routes, GeoJSON as the route server of nav2
/// reads it: each place a Point whose `id` is its number, each segment two MultiLineStrings, there
/// and back, with ids after the places', `startid` and `endid`; coordinates in metres of the frame
/// that each point names. The coordinate reference system is the one nav2 writes, since without it
/// GeoJSON means degrees. `metadata` holds the star, or the path, the arms that begin and end an
/// edge, its length and its least width.
///
/// nav2 refuses a graph without edges: a map needs a segment to be one.
///
/// @param frame  name of the layout's frame, as the robot's software has it
/// @throws std::invalid_argument unless there is a finite pose a place and a way a segment, and
///         `frame` is UTF-8
std::string route_graph_geojson(const TopologicalMap& map, const DrivenWays& ways,
                                const std::string& frame = "map");

}  // namespace asterism
