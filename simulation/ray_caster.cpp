#include "simulation/ray_caster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asterism {
namespace {

constexpr double cell_m = 1;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Walls are longer by this at both ends, so that no beam slips through where two of them meet.
constexpr double overlap_m = 1e-9;

/// How far the wall is along the beam, or infinity.
double distance_m(Point2 from, Point2 direction, const Wall& wall) {
  const Point2 side = wall.to - wall.from;
  const double sine = cross(direction, side);
  if (sine == 0) return infinity;  // a wall seen edge on is hidden by its neighbours
  const Point2 offset = wall.from - from;
  const double along_m = cross(offset, side) / sine;
  const double share = cross(offset, direction) / sine;
  const double slack = overlap_m / norm(side);
  return along_m >= 0 && share >= -slack && share <= 1 + slack ? along_m : infinity;
}

/// A cell number that is on the grid.
std::size_t clamped(double cell, std::size_t count) {
  return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(count - 1)));
}

/// One coordinate of a beam that runs from cell to cell.
struct Axis {
  double direction;
  double next_m = infinity;  ///< where along the beam it comes to the next cell
  double step_m = infinity;  ///< and how far it is across one

  /// @param offset_m  of the beam's start from the grid's edge
  Axis(double offset_m, double direction_, std::size_t cell) : direction(direction_) {
    if (direction == 0) return;
    const double edge_m = cell_m * static_cast<double>(direction > 0 ? cell + 1 : cell);
    next_m = (edge_m - offset_m) / direction;
    step_m = cell_m / std::abs(direction);
  }

  /// Goes to the next cell; false where the grid ends.
  bool advance(std::size_t& cell, std::size_t count) {
    next_m += step_m;
    if (direction < 0) return cell-- > 0;
    return ++cell < count;
  }
};

}  // namespace

/// Calls f(cell) for every cell the wall touches, and perhaps for some beside it.
void RayCaster::for_each_cell(const Wall& wall, const auto& f) const {
  constexpr double margin_m = 1e-6;
  const Point2 low = (wall.from.y_m < wall.to.y_m ? wall.from : wall.to) - origin_;
  const Point2 high = (wall.from.y_m < wall.to.y_m ? wall.to : wall.from) - origin_;
  const std::size_t last_row = clamped((high.y_m + margin_m) / cell_m, rows_);
  for (std::size_t row = clamped((low.y_m - margin_m) / cell_m, rows_); row <= last_row; ++row) {
    const auto x_at = [&](double y_m) {
      const double rise_m = high.y_m - low.y_m;
      if (rise_m == 0) return y_m < low.y_m ? low.x_m : high.x_m;
      return low.x_m + std::clamp((y_m - low.y_m) / rise_m, 0.0, 1.0) * (high.x_m - low.x_m);
    };
    const double bottom_m = cell_m * static_cast<double>(row);
    const auto [left_m, right_m] =
        std::minmax({x_at(bottom_m - margin_m), x_at(bottom_m + cell_m + margin_m)});
    const std::size_t last = clamped((right_m + margin_m) / cell_m, columns_);
    for (std::size_t column = clamped((left_m - margin_m) / cell_m, columns_); column <= last;
         ++column)
      f(row * columns_ + column);
  }
}

RayCaster::RayCaster(std::vector<Wall> walls) : walls_(std::move(walls)) {
  Point2 low{infinity, infinity};
  Point2 high{-infinity, -infinity};
  for (const Wall& wall : walls_)
    for (const Point2 end : {wall.from, wall.to}) {
      low = {std::min(low.x_m, end.x_m), std::min(low.y_m, end.y_m)};
      high = {std::max(high.x_m, end.x_m), std::max(high.y_m, end.y_m)};
    }
  if (!walls_.empty()) {
    origin_ = low;
    columns_ = static_cast<std::size_t>((high.x_m - low.x_m) / cell_m) + 1;
    rows_ = static_cast<std::size_t>((high.y_m - low.y_m) / cell_m) + 1;
  }
  first_.assign(columns_ * rows_ + 1, 0);
  for (const Wall& wall : walls_)
    for_each_cell(wall, [&](std::size_t cell) { ++first_[cell + 1]; });
  for (std::size_t cell = 0; cell + 1 < first_.size(); ++cell) first_[cell + 1] += first_[cell];
  wall_there_.resize(first_.back());
  std::vector<std::size_t> end = first_;
  for (std::size_t i = 0; i < walls_.size(); ++i)
    for_each_cell(walls_[i], [&](std::size_t cell) {
      wall_there_[end[cell]++] = static_cast<std::uint32_t>(i);
    });
}

std::optional<RayCaster::Hit> RayCaster::cast(Point2 from, Point2 direction, double max_m) const {
  // Where the beam comes onto the grid.
  double entry_m = 0;
  double exit_m = max_m;
  const auto clip = [&](double offset_m, double rate, double size_m) {
    if (rate == 0) {
      if (offset_m < 0 || offset_m > size_m) exit_m = -1;
      return;
    }
    const double to_low_m = -offset_m / rate;
    const double to_high_m = (size_m - offset_m) / rate;
    entry_m = std::max(entry_m, std::min(to_low_m, to_high_m));
    exit_m = std::min(exit_m, std::max(to_low_m, to_high_m));
  };
  const Point2 offset = from - origin_;
  clip(offset.x_m, direction.x_m, cell_m * static_cast<double>(columns_));
  clip(offset.y_m, direction.y_m, cell_m * static_cast<double>(rows_));
  if (entry_m > exit_m) return std::nullopt;

  const Point2 entry = offset + entry_m * direction;
  std::size_t column = clamped(entry.x_m / cell_m, columns_);
  std::size_t row = clamped(entry.y_m / cell_m, rows_);
  Axis x(offset.x_m, direction.x_m, column);
  Axis y(offset.y_m, direction.y_m, row);
  Hit best{infinity, false};
  while (true) {
    const std::size_t cell = row * columns_ + column;
    for (std::size_t i = first_[cell]; i < first_[cell + 1]; ++i) {
      const Wall& wall = walls_[wall_there_[i]];
      const double here_m = distance_m(from, direction, wall);
      if (here_m < best.distance_m) best = {here_m, wall.is_glass};
    }
    const double left_at_m = std::min(x.next_m, y.next_m);
    if (best.distance_m <= left_at_m || left_at_m > max_m) break;
    const bool is_on_grid =
        x.next_m < y.next_m ? x.advance(column, columns_) : y.advance(row, rows_);
    if (!is_on_grid) break;
  }
  return best.distance_m <= max_m ? std::optional(best) : std::nullopt;
}

}  // namespace asterism
