#pragma once

#include <vector>

#include "core/map_drawing.hpp"
#include "core/topological_map.hpp"

namespace asterism {

/// Draws a map as draw() does, turned to lie as its places are laid out: see turned(). Of a map in
/// pieces each is drawn and turned for itself; they stand side by side, from left to right.
///
/// @param as  one a place: where it is laid out, in any unit
/// @throws std::invalid_argument unless there are as many as places
MapDrawing draw_as_laid_out(const TopologicalMap& map, const std::vector<MapDrawing::Point>& as);

}  // namespace asterism
