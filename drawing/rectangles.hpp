#pragma once

#include "drawing/plane_graph.hpp"

namespace asterism {

/// The graph in a rectangular frame, with helper edges that cut its faces into rectangles: each
/// reflex corner is prolonged up to the edge in front of it. Vertices and darts of `graph` keep
/// their numbers; darts whose edge was cut end at the first cut.              [T87]
///
/// @pre turns round each inner face add up to 4, round the outer one to -4
PlaneGraph cut_into_rectangles(const PlaneGraph& graph);

/// Where each dart leads if `north` leads north: quarter turns from east, counter-clockwise, 0
/// to 3.
std::vector<int> directions(const PlaneGraph& graph, std::size_t north);

}  // namespace asterism
