#pragma once

#include "drawing/plane_graph.hpp"

namespace asterism {

/// Bends the edges of a connected plane graph, as few times as possible, until turns round each
/// inner face add up to 4 and round the outer one to -4: then it can be drawn with all edges
/// horizontal or vertical. Reduced to a cheapest flow of quarter turns between faces [T87].
/// The outer face is the one that costs least.
PlaneGraph with_orthogonal_shape(const PlaneGraph& graph);

/// The sum of turns round the face of a dart.
int turns(const PlaneGraph& graph, std::size_t dart);

}  // namespace asterism
