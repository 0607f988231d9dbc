#pragma once

#include <vector>

#include "drawing/plane_graph.hpp"

namespace asterism {

/// A point with whole coordinates.
struct GridPoint {
  long x = 0;  ///< to the right
  long y = 0;  ///< up
  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

constexpr long cage_side = 2;  ///< least length of a piece of a cage's rim, in grid steps

/// Where the vertices of a connected graph of orthogonal shape lie on a grid: edges horizontal or
/// vertical, none crossing, segments short and of like length, stubs of length 1.
///
/// First faces are cut into rectangles, which any lengths fit; then columns and rows in turn are
/// moved together as a linear program, the dual of a cheapest flow.
///
/// @param north  a dart that is to lead north
/// @pre turns round each inner face add up to 4, round the outer one to -4
std::vector<GridPoint> grid_layout(const PlaneGraph& graph, std::size_t north);

}  // namespace asterism
