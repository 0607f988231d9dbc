#pragma once

#include <cstdint>
#include <vector>

#include "perception/bit_rows.hpp"

namespace asterism {

/// A picture a byte a cell: row by row, not 0 belongs to the figure.
using Picture = std::vector<std::uint8_t>;
BitRows bit_rows(const Picture& picture, int width, int height);
Picture picture_of(const BitRows& rows);

/// The two subiterations as the paper words them, cell by cell, until no more go.      [ZS84]
/// @return  the picture after every subiteration that took something away, the first as given
std::vector<Picture> plain_thinning(const Picture& picture, int width, int height);

/// Of each cell of the figure (or, if not `figure`, of the rest), the number of its piece from 1
/// on; 0 elsewhere. The figure's pieces are 8-connected, the others' 4-connected.
std::vector<int> pieces_of(const Picture& picture, int width, int height, bool figure = true);

}  // namespace asterism
