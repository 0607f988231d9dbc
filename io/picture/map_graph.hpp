#pragma once

#include <span>
#include <string>

#include "core/driven_way.hpp"
#include "core/pose2.hpp"
#include "core/topological_map.hpp"

namespace asterism {

/// A topological map as a graph for other programs: a node a place, an undirected edge a segment.
///
/// A node is named p and the place's number and has `star` (its arms clockwise, as in a maps file),
/// `first_visit`, `paths` (the numbers of the paths through it) and, where the map is laid out,
/// `x_m`, `y_m` and `heading_rad`. An edge is named s and the segment's number and has
/// `source_arm`, `target_arm` (as named in the stars), `path` and, where the ways driven are given,
/// `length_m`, `width_m` and `line`, from source to target as well-known text.
///
/// @param layout_from_place  one a place, or none where the map is not laid out
/// @param ways               one a segment, or none
/// @throws std::invalid_argument if there are some but not one each, or not finite

/// GraphML.
std::string map_graphml(const TopologicalMap& map, std::span<const Pose2> layout_from_place = {},
                        std::span<const DrivenWay> ways = {});

/// DOT, the language of Graphviz. Places that are laid out are pinned there, 5 m an inch, for
/// neato.
std::string map_dot(const TopologicalMap& map, std::span<const Pose2> layout_from_place = {},
                    std::span<const DrivenWay> ways = {});

}  // namespace asterism
