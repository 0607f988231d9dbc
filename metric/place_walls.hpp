#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/grid.hpp"

namespace asterism {

/// A bit of wall: a point of it, and the direction it faces (either one of the two).
struct WallPiece {
  Point2 point = {};
  Point2 normal = {};  ///< of length 1
};

/// The walls of a place map, in its visit's frame, and which of them is near to a point.
/// A value: threads may read one side by side.
class PlaceWalls {
 public:
  /// Farther than this from every wall, a point is near to none.
  static constexpr double reach_m = 1.0;

  /// @param radius_m  walls farther from the frame's origin are left out
  PlaceWalls(const Grid& place_map, double radius_m);

  /// All pieces, row by row of the map.
  const std::vector<WallPiece>& pieces() const noexcept { return pieces_; }
  /// The piece of wall nearest to a point; null where none is within reach.
  const WallPiece* nearest(Point2 in_place) const;
  /// Whether the map knows what there is at a point.
  bool is_known(Point2 in_place) const;

 private:
  void add_piece(const Grid& place_map, Cell cell);
  void spread(std::size_t piece, std::vector<double>& squares_m2);
  Point2 in_grid(Point2 in_place) const;
  std::optional<std::size_t> cell_at(Point2 in_place) const;

  Grid frame_;     ///< the map's, without its cells
  Point2 facing_;  ///< along the grid's rows, in the place's frame
  std::vector<bool> known_;
  std::vector<WallPiece> pieces_;
  std::vector<int> nearest_;  ///< by cell: piece, or no_piece
};

}  // namespace asterism
