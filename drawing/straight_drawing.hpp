#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/map_drawing.hpp"

namespace asterism {

/// Where each place is drawn, segments being straight lines.
struct StraightDrawing {
  std::vector<MapDrawing::Point> vertices;
  bool without_crossings = false;  ///< drawn with straight edges, parallel ones as one
};

/// Where to put the vertices of a graph whose edges have no order round them, for straight edges:
/// in a circle if none cross then; else where Chrobak and Payne put them, if the graph is planar;
/// else in a circle all the same. Units as in MapDrawing.                    [BM04] [CP95]
///
/// An edge from a vertex to itself is taken to have room enough.
///
/// @pre the graph is connected
StraightDrawing draw_straight(std::size_t vertices,
                              std::span<const std::pair<std::size_t, std::size_t>> edges);

}  // namespace asterism
