#pragma once

#include <cstddef>
#include <span>
#include <utility>

#include "core/topological_map.hpp"

namespace asterism {

/// Can places and segments be drawn in the plane at all, whatever the order round a place?
/// Boyer and Myrvold's test; every map that is_planar accepts passes it.            [theory §7]
bool is_planar_graph(const TopologicalMap& map);

/// Whether a graph can be drawn in the plane: its edges join vertices, numbered from 0.
bool is_planar_graph(std::size_t vertices,
                     std::span<const std::pair<std::size_t, std::size_t>> edges);

}  // namespace asterism
