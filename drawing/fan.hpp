#pragma once

#include <vector>

#include "core/map_drawing.hpp"

namespace asterism {

/// How the arms of a place run from its centre to the rim of its cage, in order: each straight to a
/// knee, `radius` away, and straight on. The knees are spread evenly round the centre, so that
/// opposite arms of an even star leave in opposite directions; less evenly, where lines would meet
/// or nearly so.
///
/// @param rim  clockwise, on a convex outline round the centre, farther from it than `radius`
std::vector<MapDrawing::Polyline> fan(MapDrawing::Point centre,
                                      const std::vector<MapDrawing::Point>& rim, double radius);

}  // namespace asterism
