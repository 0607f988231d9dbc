#pragma once

#include <array>

#include "core/grid.hpp"

namespace asterism {

/// The steps to the eight cells round one, clockwise from the north.
inline constexpr std::array<Cell, 8> ring_steps{
    {{0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}}};

/// A cell, and a step from it.
inline Cell operator+(Cell a, Cell b) { return {a.column + b.column, a.row + b.row}; }

/// Squared distance between the middles of two cells, in cells.
inline int squared_distance(Cell a, Cell b) {
  const int right = a.column - b.column;
  const int up = a.row - b.row;
  return right * right + up * up;
}

}  // namespace asterism
