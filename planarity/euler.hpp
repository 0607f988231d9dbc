#pragma once

#include <optional>
#include <vector>

#include "core/topological_map.hpp"

namespace asterism {

/// The faces of a map, as its stars imply them: orbits of "arrive by gateway h, go on by the next
/// gateway clockwise after h that has a segment (h itself if alone)".                [theory §7]
/// Each face lists the gateways left by, in order, from its smallest; the face lies to the left.
/// Every gateway with a segment is in exactly one face; gateways without a segment are in none.
std::vector<std::vector<PlaceArm>> faces(const TopologicalMap& map);

/// Can the map be drawn in the plane with the clockwise orders of its stars?  [SK04] [theory §7]
/// V - E + F = 2. A map in several pieces is planar iff each piece is; a place without segments is.
bool is_planar(const TopologicalMap& map);

/// What of the map cannot be drawn: all of it, if it is not planar. Where axioms let a gateway have
/// more than one segment, stars do not say in which order these leave it: then such a map cannot be
/// drawn if some part of it cannot in which each gateway has one at most; that part.
/// @return nothing if all can be drawn; else the map with fewer segments
std::optional<TopologicalMap> part_not_planar(const TopologicalMap& map);

}  // namespace asterism
