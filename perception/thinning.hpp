#pragma once

#include <cstdint>
#include <vector>

namespace asterism {

/// Thins a picture to lines one cell wide, keeping what is connected connected: the parallel
/// algorithm of [ZS84], 64 cells at a time.
///
/// @param picture  row by row, `width` · `height` cells, not 0: belongs to the figure
/// @return  1 where the thinned figure is, else 0
std::vector<std::uint8_t> thinned(const std::vector<std::uint8_t>& picture, int width, int height);

}  // namespace asterism
