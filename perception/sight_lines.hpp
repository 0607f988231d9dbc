#pragma once

#include <algorithm>
#include <cmath>

#include "perception/free_space.hpp"

namespace asterism {

/// Looks along straight lines through free space, in steps of half a cell. Threads may ask
/// one side by side.
class SightLines {
 public:
  /// @param space  must outlive this
  explicit SightLines(const FreeSpace& space)
      : space_(space),
        steps_per_m_(2 / space.frame.resolution_m),
        grid_from_frame_(inverse(space.frame.frame_from_grid)),
        x_axis_(unit_vector(grid_from_frame_.heading_rad)) {}

  /// How long a step is.
  double step_m() const { return 0.5 * space_.frame.resolution_m; }

  /// The cell round a point of the frame, as Grid::cell_at finds it, without an inverse each time.
  Cell cell_at(Point2 in_frame) const { return cell(in_cells(in_frame)); }

  /// A line from a point of the frame. Points of it are in cells.
  class Line {
   public:
    /// The cell that so many steps lead to.
    Cell cell_at(int step) const { return cell(from_ + step * along_); }

   private:
    friend class SightLines;
    Line(Point2 from, Point2 along) : from_(from), along_(along) {}
    Point2 from_;
    Point2 along_;
  };
  /// The line from a point that way; both in the frame.
  /// @param along  of length 1
  Line line(Point2 from, Point2 along) const {
    return {in_cells(from), 0.5 * turned(x_axis_, along)};
  }

  /// From anywhere in a free cell so many steps, all but the last, end in free cells: the middles
  /// of two cells may be one cell and a half farther apart than two points in them.
  int stride(double clearance_m) const {
    return std::max(1, static_cast<int>(clearance_m * steps_per_m_) - 1);
  }

  /// Steps from a point to the first that ends in a cell that is not free; `most` if none does.
  int free_steps(Point2 from, Point2 along, int most) const {
    const Line looked = line(from, along);
    for (int step = 0; step < most;) {
      const double clearance_m = space_.clearance(looked.cell_at(step));
      if (clearance_m == 0) return step;
      step += stride(clearance_m);
    }
    return most;
  }

 private:
  static Cell cell(Point2 in_cells) {
    return {static_cast<int>(std::floor(in_cells.x_m)), static_cast<int>(std::floor(in_cells.y_m))};
  }
  Point2 in_cells(Point2 in_frame) const {
    return 1 / space_.frame.resolution_m *
           (grid_from_frame_.position() + turned(x_axis_, in_frame));
  }

  const FreeSpace& space_;
  double steps_per_m_;
  Pose2 grid_from_frame_;
  Point2 x_axis_;  ///< of the frame, in the grid's
};

}  // namespace asterism
