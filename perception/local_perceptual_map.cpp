#include "perception/local_perceptual_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace asterism {
namespace {

constexpr int bridged_beams =
    5;  // so many beams without a return between two with one are free space
constexpr double wall_gap_m = 0.9;  // returns of neighbouring beams so far apart may be one wall
constexpr double straight_rad = 0.15;
constexpr double footprint_m = 0.25;  // where the robot stands is free

bool is_straight(Point2 before, Point2 corner, Point2 after) {
  const Point2 come = corner - before;
  const Point2 go = after - corner;
  return dot(come, go) > std::cos(straight_rad) * norm(come) * norm(go);
}

}  // namespace

LocalPerceptualMap::LocalPerceptualMap(const LpmOptions& options) : options_(options) {
  const auto cells = static_cast<std::size_t>(options.cells);
  const double half_m = options.cells / 2 * options.resolution_m;
  grid_ = {.width = options.cells,
           .height = options.cells,
           .resolution_m = options.resolution_m,
           .frame_from_grid = {-half_m, -half_m, 0},
           .log_odds = std::vector<float>(cells * cells, 0.0F)};
  drawn_.assign(cells * cells, 0);
  walls_.assign(cells * cells, {});
}

void LocalPerceptualMap::scroll_to(Point2 robot) {
  const Cell at = grid_.cell_at(robot);
  const int right = at.column - grid_.width / 2;
  const int up = at.row - grid_.height / 2;
  if (right == 0 && up == 0) return;

  std::vector<float> moved(grid_.log_odds.size(), 0.0F);
  std::vector<WallPoint> moved_walls(walls_.size());
  ++version_;
  const int first = std::max(0, -right);
  const int last = std::min(grid_.width, grid_.width - right);
  for (int row = std::max(0, -up); row < std::min(grid_.height, grid_.height - up); ++row) {
    if (first >= last) break;
    const auto from = grid_.log_odds.begin() +
                      static_cast<std::ptrdiff_t>(grid_.index({first + right, row + up}));
    std::copy(from, from + (last - first),
              moved.begin() + static_cast<std::ptrdiff_t>(grid_.index({first, row})));
    const auto wall =
        walls_.begin() + static_cast<std::ptrdiff_t>(grid_.index({first + right, row + up}));
    std::copy(wall, wall + (last - first),
              moved_walls.begin() + static_cast<std::ptrdiff_t>(grid_.index({first, row})));
  }
  grid_.log_odds = std::move(moved);
  walls_ = std::move(moved_walls);
  grid_.frame_from_grid.x_m += right * grid_.resolution_m;
  grid_.frame_from_grid.y_m += up * grid_.resolution_m;
}

void LocalPerceptualMap::update(const Scan& scan, const Pose2& map_from_robot) {
  ++scan_;
  ++version_;
  const Pose2 map_from_laser = map_from_robot * scan.laser.robot_from_laser;
  const Cell from = grid_.cell_at(map_from_laser.position());
  const auto end_of = [&](double beam_rad, double range_m) {
    return grid_.cell_at(map_from_laser * (range_m * unit_vector(beam_rad)));
  };
  ends_.clear();
  wall_.clear();
  double last_m = 0;               // range of the last return
  int missed = bridged_beams + 1;  // beams since then
  for (std::size_t beam = 0; beam < scan.ranges_m.size(); ++beam) {
    // No return at all may be glass or a black wall: nothing is said about its cells.
    if (scan.ranges_m[beam] >= scan.laser.max_range_m) {
      ++missed;
      draw_wall();
      continue;
    }
    const double range_m = std::min(scan.ranges_m[beam], options_.usable_range_m);
    const double beam_rad = scan.laser.beam_rad(beam);
    ends_.push_back(end_of(beam_rad, range_m));
    if (range_m == scan.ranges_m[beam]) {
      add(ends_.back(), options_.hit);
      wall_.push_back(map_from_laser * (range_m * unit_vector(beam_rad)));
      add_return(ends_.back(), wall_.back());
    } else {
      draw_wall();
    }
    // Between two returns space is free as far as the nearer one: no streaks between far beams.
    if (missed <= bridged_beams) {
      const double nearer_m = std::min(last_m, range_m) - grid_.resolution_m;
      const double gap_rad = (missed + 1) * scan.laser.beam_step_rad;
      const int rays = static_cast<int>(nearer_m * std::abs(gap_rad) / (0.7 * grid_.resolution_m));
      for (int ray = 1; ray <= rays; ++ray) {
        ends_.push_back(end_of(beam_rad - ray * gap_rad / (rays + 1), nearer_m));
      }
    }
    last_m = range_m;
    missed = 0;
  }
  draw_wall();
  for (const Cell end : ends_) trace(from, end);
  draw_footprint(map_from_robot.position());
}

// Seen flat, a wall returns few beams: between two of them that lie in line with a third it goes
// on.
void LocalPerceptualMap::draw_wall() {
  for (std::size_t i = 0; i + 1 < wall_.size(); ++i) {
    const Point2 gap = wall_[i + 1] - wall_[i];
    const int steps = static_cast<int>(norm(gap) / (0.5 * grid_.resolution_m));
    if (steps < 2 || norm(gap) > wall_gap_m) continue;
    const bool straight =
        (i > 0 && is_straight(wall_[i - 1], wall_[i], wall_[i + 1])) ||
        (i + 2 < wall_.size() && is_straight(wall_[i], wall_[i + 1], wall_[i + 2]));
    for (int step = 1; straight && step < steps; ++step) {
      add(grid_.cell_at(wall_[i] + (1.0 * step / steps) * gap), options_.hit);
    }
  }
  wall_.clear();
}

void LocalPerceptualMap::draw_footprint(Point2 robot) {
  const int reach = static_cast<int>(footprint_m / grid_.resolution_m);
  const Cell at = grid_.cell_at(robot);
  for (int up = -reach; up <= reach; ++up) {
    for (int right = -reach; right <= reach; ++right) {
      add({at.column + right, at.row + up}, options_.miss);
    }
  }
}

// Bresenham's line, without its last cell.
void LocalPerceptualMap::trace(Cell from, Cell to) {
  const int columns = std::abs(to.column - from.column);
  const int rows = std::abs(to.row - from.row);
  const int right = to.column > from.column ? 1 : -1;
  const int up = to.row > from.row ? 1 : -1;
  int error = columns - rows;
  for (Cell cell = from; !(cell == to);) {
    if (!grid_.contains(cell)) return;
    add(cell, options_.miss);
    const int twice = 2 * error;
    if (twice > -rows) {
      error -= rows;
      cell.column += right;
    }
    if (twice < columns) {
      error += columns;
      cell.row += up;
    }
  }
}

void LocalPerceptualMap::add_return(Cell cell, Point2 point) {
  if (!grid_.contains(cell)) return;
  WallPoint& wall = walls_[grid_.index(cell)];
  if (wall.returns >= options_.most_returns) return;
  ++wall.returns;
  wall.mean = wall.mean + (1.0 / wall.returns) * (point - wall.mean);
}

void LocalPerceptualMap::add(Cell cell, double log_odds) {
  if (!grid_.contains(cell)) return;
  const std::size_t at = grid_.index(cell);
  if (drawn_[at] == scan_) return;
  drawn_[at] = scan_;
  grid_.log_odds[at] = static_cast<float>(
      std::clamp(grid_.log_odds[at] + log_odds, -options_.bound, options_.bound));
}

}  // namespace asterism
