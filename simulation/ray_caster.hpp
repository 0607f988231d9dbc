#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/pose2.hpp"
#include "simulation/floor_plan.hpp"

namespace asterism {

/// Finds the first wall that a beam hits, exactly. Walls are sorted into the cells of a grid once,
/// so that a beam looks at those on its way only. A value: threads may ask one side by side.
class RayCaster {
 public:
  /// Where a beam ends.
  struct Hit {
    double distance_m;
    bool is_glass;
  };

  /// @param walls  in the frame that beams will be told in, m
  explicit RayCaster(std::vector<Wall> walls);

  /// The nearest wall at most `max_m` away.
  /// @param direction  of length 1
  std::optional<Hit> cast(Point2 from, Point2 direction, double max_m) const;

  /// All walls, as given.
  std::span<const Wall> walls() const noexcept { return walls_; }

 private:
  void for_each_cell(const Wall& wall, const auto& f) const;

  std::vector<Wall> walls_;
  Point2 origin_;  ///< lower left corner of the grid
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<std::size_t> first_;         ///< [cell]: where its walls begin, and one more
  std::vector<std::uint32_t> wall_there_;  ///< the walls of all cells, cell by cell
};

}  // namespace asterism
