#pragma once

#include <array>

#include "core/grid.hpp"

namespace asterism {

/// The steps to the eight cells round one, clockwise from the north.
inline constexpr std::array<Cell, 8> kRing{
    {{0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}}};

inline Cell operator+(Cell a, Cell b) { return {a.column + b.column, a.row + b.row}; }

/// Of their middles, in cells.
inline int squared_distance(Cell a, Cell b) {
  const int right = a.column - b.column;
  const int up = a.row - b.row;
  return right * right + up * up;
}

}  // namespace asterism
