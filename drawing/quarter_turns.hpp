#pragma once

#include <vector>

#include "core/map_drawing.hpp"

namespace asterism {

/// A drawing turned by quarters, never mirrored, until its places lie as near as can be to the way
/// that others do: their offsets from their middles have the greatest inner product. Of turns alike
/// the least.
///
/// @param as  one a place, in any unit: those of a layout, say
/// @throws std::invalid_argument unless there are as many as places
MapDrawing turned(MapDrawing drawing, const std::vector<MapDrawing::Point>& as);

}  // namespace asterism
