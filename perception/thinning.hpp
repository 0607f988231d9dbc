#pragma once

#include "perception/bit_rows.hpp"

namespace asterism {

/// Thins a picture to lines one cell wide, keeping what is connected connected: the parallel
/// algorithm of [ZS84], 64 cells at a time.
///
/// @param picture  set where there is something to thin
/// @param anchors  cells that stay whatever happens; a picture as large, or nothing
BitRows thinned(BitRows picture, const BitRows& anchors = {});

}  // namespace asterism
