#pragma once

#include <vector>

#include "drawing/grid_layout.hpp"
#include "drawing/plane_graph.hpp"

namespace asterism {

/// Segments that go straight on from a cage can pull it wide. This gives them two opposite bends
/// each, beside the cage, so that the next layout can make the cage small.
///
/// @param layout  of `graph`
/// @return  the graph with jogs, of orthogonal shape again; has as many darts as `graph` if no cage
///          was wide
PlaneGraph with_jogs(const PlaneGraph& graph, const std::vector<GridPoint>& layout);

}  // namespace asterism
