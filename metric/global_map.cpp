#include "metric/global_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace asterism {
namespace {

// Rays are traced in whole parts of a cell, so that which cells they cross is exact.
constexpr int part_bits = 20;
constexpr std::int64_t parts_a_cell = std::int64_t{1} << part_bits;
// ... and two cells' distance in parts, times the parts of a cell, is below 2^63.
constexpr double most_cells_a_side = 1 << 20;

// Where a beam ends, in the layout's frame.
struct Ray {
  Point2 end = {};
  bool is_return = false;
};

// What a cell has seen; 8 bytes, which one access to memory brings.
struct Tally {
  std::uint32_t scan = 0;  // drawn last, counted from 1
  std::uint16_t hits = 0;
  std::uint16_t misses = 0;

  static constexpr std::uint16_t most = std::numeric_limits<std::uint16_t>::max();
};

[[noreturn]] void refuse(const std::string& found, const std::string& expected) {
  throw std::invalid_argument("global map: found " + found + "; expected " + expected);
}

void require_fit(std::span<const Scan> scans, const Trajectory& trajectory,
                 const GlobalMapOptions& options) {
  if (scans.empty()) refuse("no scan", "one or more");
  if (scans.size() != trajectory.size()) {
    refuse(std::to_string(trajectory.size()) + " poses",
           "one for each of " + std::to_string(scans.size()) + " scans");
  }
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const Pose2& pose = trajectory[i].layout_from_robot;
    if (!std::isfinite(pose.x_m + pose.y_m + pose.heading_rad)) {
      refuse("no number in pose " + std::to_string(i), "finite ones");
    }
  }
  for (const double option : {options.resolution_m, options.usable_range_m, options.clear_range_m,
                              options.margin_m, options.hit, -options.miss, options.bound}) {
    if (!(option > 0) || !std::isfinite(option)) {
      refuse("option " + std::to_string(option), "more than 0 (the miss: less)");
    }
  }
}

// Indices of the scans to draw. The first is one of them.
std::vector<std::size_t> sharp_and_new(const Trajectory& trajectory,
                                       const GlobalMapOptions& options) {
  const auto since = [&](std::size_t before, std::size_t after) {
    return inverse(trajectory[before].layout_from_robot) * trajectory[after].layout_from_robot;
  };
  const auto turns_fast = [&](std::size_t before, std::size_t after) {
    const double turned_rad = std::abs(since(before, after).heading_rad);
    const double passed_s = std::abs(trajectory[after].stamp_s - trajectory[before].stamp_s);
    return turned_rad > options.blurred_rad && turned_rad > options.blurred_rad_per_s * passed_s;
  };
  std::vector<std::size_t> result{0};
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    const Pose2 moved = since(result.back(), i);
    if (norm(moved.position()) <= options.redraw_m &&
        std::abs(moved.heading_rad) <= options.redraw_rad) {
      continue;
    }
    if (turns_fast(i - 1, i) || (i + 1 < trajectory.size() && turns_fast(i, i + 1))) continue;
    result.push_back(i);
  }
  return result;
}

// The rays of a scan, one a beam.
void cast(const Scan& scan, const Pose2& layout_from_robot, const GlobalMapOptions& options,
          std::vector<Ray>& rays) {
  const Pose2 layout_from_laser = layout_from_robot * scan.laser.robot_from_laser;
  rays.clear();
  for (std::size_t beam = 0; beam < scan.ranges_m.size(); ++beam) {
    const double range_m = scan.ranges_m[beam];
    const bool returned = range_m < scan.laser.max_range_m;
    const double free_m =
        returned ? std::min(range_m, options.usable_range_m) : options.clear_range_m;
    const Point2 direction = unit_vector(layout_from_laser.heading_rad + scan.laser.beam_rad(beam));
    rays.push_back({.end = layout_from_laser.position() + free_m * direction,
                    .is_return = returned && range_m <= options.usable_range_m});
  }
}

class Drawing {
 public:
  Drawing(Point2 low, Point2 high, const GlobalMapOptions& options) : options_(options) {
    for (grid_.resolution_m = options.resolution_m; !fit(low, high); grid_.resolution_m *= 2)
      if (!std::isfinite(grid_.resolution_m)) refuse("no bounds", "finite ranges");
    tallies_.resize(static_cast<std::size_t>(grid_.width) * static_cast<std::size_t>(grid_.height));
  }

  void draw(Point2 laser, std::span<const Ray> rays) {
    ++scan_;
    for (const Ray& ray : rays) {
      if (ray.is_return) count_hit(tallies_[index(parts(ray.end))]);
    }
    const Parts from = parts(laser);
    for (const Ray& ray : rays) trace(from, parts(ray.end));
  }

  Grid grid() && {
    grid_.log_odds.reserve(tallies_.size());
    for (const Tally& tally : tallies_) {
      const double sum = options_.hit * tally.hits + options_.miss * tally.misses;
      grid_.log_odds.push_back(
          static_cast<float>(std::clamp(sum, -options_.bound, options_.bound)));
    }
    return std::move(grid_);
  }

 private:
  // Lays the grid round all between two corners, if cells of its resolution are not too many.
  bool fit(Point2 low, Point2 high) {
    const auto cells = [&](double m) { return std::floor(m / grid_.resolution_m); };
    const double margin = cells(options_.margin_m) + 1;  // rounding leads no ray off the grid
    const Point2 corner{cells(low.x_m) - margin, cells(low.y_m) - margin};
    const double width = cells(high.x_m) + margin + 1 - corner.x_m;
    const double height = cells(high.y_m) + margin + 1 - corner.y_m;
    if (!(width * height <= static_cast<double>(options_.max_cells)) ||
        !(std::max(width, height) <= most_cells_a_side))
      return false;
    grid_.width = static_cast<int>(width);
    grid_.height = static_cast<int>(height);
    grid_.frame_from_grid = {corner.x_m * grid_.resolution_m, corner.y_m * grid_.resolution_m, 0};
    return true;
  }

  // A point, in parts of a cell from the grid's corner.
  struct Parts {
    std::int64_t x = 0;
    std::int64_t y = 0;
  };

  Parts parts(Point2 in_layout) const {
    const double parts_per_m = static_cast<double>(parts_a_cell) / grid_.resolution_m;
    return {static_cast<std::int64_t>((in_layout.x_m - grid_.frame_from_grid.x_m) * parts_per_m),
            static_cast<std::int64_t>((in_layout.y_m - grid_.frame_from_grid.y_m) * parts_per_m)};
  }
  std::size_t index(Parts at) const {
    return static_cast<std::size_t>((at.y >> part_bits) * grid_.width + (at.x >> part_bits));
  }

  void count_hit(Tally& tally) {
    if (tally.scan == scan_) return;
    tally.scan = scan_;
    if (tally.hits < Tally::most) ++tally.hits;
  }

  // Counts a miss in each cell that a line crosses, but the last. Where `lead` is positive the line
  // leaves the cell by its side, else by its end: it is the way to the end over dy, less the way to
  // the side over dx, times both.
  void trace(Parts from, Parts to) {
    const std::int64_t right = to.x - from.x;
    const std::int64_t up = to.y - from.y;
    const std::int64_t dx = std::abs(right);
    const std::int64_t dy = std::abs(up);
    const std::int64_t x_in_cell = from.x & (parts_a_cell - 1);
    const std::int64_t y_in_cell = from.y & (parts_a_cell - 1);
    const std::int64_t to_side = right < 0 ? x_in_cell : parts_a_cell - x_in_cell;
    const std::int64_t to_end = up < 0 ? y_in_cell : parts_a_cell - y_in_cell;
    const std::int64_t to_column = right < 0 ? -1 : 1;
    const std::int64_t to_row = up < 0 ? -grid_.width : grid_.width;
    const std::int64_t cells = std::abs((to.x >> part_bits) - (from.x >> part_bits)) +
                               std::abs((to.y >> part_bits) - (from.y >> part_bits));
    const std::int64_t column_lead = dy << part_bits;
    const std::int64_t row_lead = dx << part_bits;
    std::int64_t lead = dx * to_end - dy * to_side;
    Tally* cell = &tallies_[index(from)];
    for (std::int64_t i = 0; i < cells; ++i) {
      if (cell->scan != scan_) {
        cell->scan = scan_;
        if (cell->misses < Tally::most) ++cell->misses;
      }
      const bool leaves_column = lead > 0;
      cell += leaves_column ? to_column : to_row;
      lead += leaves_column ? -column_lead : row_lead;
    }
  }

  const GlobalMapOptions& options_;
  Grid grid_ = {};
  std::vector<Tally> tallies_ = {};
  std::uint32_t scan_ = 0;
};

}  // namespace

Grid global_map(std::span<const Scan> scans, const Trajectory& trajectory,
                const GlobalMapOptions& options) {
  require_fit(scans, trajectory, options);
  const std::vector<std::size_t> drawn = sharp_and_new(trajectory, options);
  const auto layout_from_robot = [&](std::size_t i) -> const Pose2& {
    return trajectory[i].layout_from_robot;
  };
  const auto laser = [&](std::size_t i) {
    return (layout_from_robot(i) * scans[i].laser.robot_from_laser).position();
  };
  std::vector<Ray> rays;
  Point2 low = laser(drawn.front());
  Point2 high = low;
  const auto include = [&](Point2 point) {
    low = {std::min(low.x_m, point.x_m), std::min(low.y_m, point.y_m)};
    high = {std::max(high.x_m, point.x_m), std::max(high.y_m, point.y_m)};
  };
  for (const std::size_t i : drawn) {
    cast(scans[i], layout_from_robot(i), options, rays);
    include(laser(i));
    for (const Ray& ray : rays) include(ray.end);
  }
  Drawing drawing(low, high, options);
  for (const std::size_t i : drawn) {
    cast(scans[i], layout_from_robot(i), options, rays);
    drawing.draw(laser(i), rays);
  }
  return std::move(drawing).grid();
}

}  // namespace asterism
