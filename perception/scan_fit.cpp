#include "perception/scan_fit.hpp"

#include <algorithm>
#include <cmath>

#include "core/plane_covariance.hpp"
#include "core/squared.hpp"

namespace asterism {
namespace {

// A wall stands until it was seen through many times: a map's own walls fade where beams graze
// them.
constexpr float gone_log_odds = -1.5F;
constexpr float unknown_log_odds = 0.3F;  // log-odds nearer 0 say nothing
constexpr int no_wall = -1;
constexpr int nothing_known = -2;  // ... and no one knows what there is
constexpr int round_cells =
    2;  // cells round one that tell its wall's direction, or else twice as many
constexpr double fewest_points = 3;
constexpr double along_factor =
    100;  // spread along a wall, in which distances do not count, times this
constexpr double odd_turn_cost = 25;  // a turn that the wheels missed costs no more than this
constexpr double done_m = 2e-4;
constexpr double done_rad = 5e-5;

bool has_wall(const LocalPerceptualMap& map, std::size_t cell) {
  return map.walls()[cell].returns > 0 && map.grid().log_odds[cell] > gone_log_odds;
}

// How the points of the walls round a cell spread, told from the cell's own.
PointSpread spread(const LocalPerceptualMap& map, Cell cell, int round) {
  const Grid& grid = map.grid();
  const Point2 here = map.walls()[grid.index(cell)].mean;
  PointSpread sum;
  grid.for_each_round(cell, round, [&](Cell other) {
    const std::size_t at = grid.index(other);
    if (has_wall(map, at)) sum.add(map.walls()[at].mean - here);
  });
  return sum;
}

// What a distance from a wall of this spread tells: the inverse of its covariance.
std::array<double, 3> information(const PlaneCovariance& spread, double sigma_m) {
  const double variance = squared(sigma_m);
  const double half = spread.half();
  const double across = spread.middle() - half + variance;
  const double along = along_factor * (across + 2 * half - variance) + variance;
  const Point2 wall = spread.along();
  const auto part = [&](double ww, double nn) { return ww / along + nn / across; };
  return {part(wall.x_m * wall.x_m, wall.y_m * wall.y_m),
          part(wall.x_m * wall.y_m, -wall.x_m * wall.y_m),
          part(wall.y_m * wall.y_m, wall.x_m * wall.x_m)};
}

// Of a symmetric, positive definite matrix.
PoseCovariance inverted(const PoseCovariance& m) {
  const double a = m[4] * m[8] - m[5] * m[5];
  const double b = m[2] * m[5] - m[1] * m[8];
  const double c = m[1] * m[5] - m[2] * m[4];
  const double determinant = m[0] * a + m[1] * b + m[2] * c;
  const double e = (m[0] * m[8] - m[2] * m[2]) / determinant;
  const double f = (m[1] * m[2] - m[0] * m[5]) / determinant;
  const double i = (m[0] * m[4] - m[1] * m[1]) / determinant;
  return {a / determinant,
          b / determinant,
          c / determinant,
          b / determinant,
          e,
          f,
          c / determinant,
          f,
          i};
}

}  // namespace

void ScanFit::draw(const LocalPerceptualMap& map) {
  const Grid& grid = map.grid();
  frame_ = frame_of(grid);
  wall_of_cell_.assign(grid.log_odds.size(), no_wall);
  walls_.clear();
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      const std::size_t at = grid.index({column, row});
      if (std::abs(grid.log_odds[at]) < unknown_log_odds) wall_of_cell_[at] = nothing_known;
      if (!has_wall(map, at)) continue;
      PointSpread round = spread(map, {column, row}, round_cells);
      if (round.count() < fewest_points) round = spread(map, {column, row}, 2 * round_cells);
      if (round.count() < fewest_points) continue;
      wall_of_cell_[at] = static_cast<int>(walls_.size());
      walls_.push_back({map.walls()[at].mean, information(round.covariance(), options_.sigma_m)});
    }
  }
}

const ScanFit::Wall* ScanFit::nearest(Point2 in_map) const {
  const int reach = static_cast<int>(options_.reach_m / frame_.resolution_m);
  const Cell at = frame_.cell_at(in_map);
  if (!frame_.contains({at.column - reach, at.row - reach}) ||
      !frame_.contains({at.column + reach, at.row + reach}))
    return nullptr;
  const Wall* best = nullptr;
  double least_m2 = options_.reach_m * options_.reach_m;
  for (int row = at.row - reach; row <= at.row + reach; ++row) {
    const int* const cells = &wall_of_cell_[frame_.index({at.column - reach, row})];
    for (int cell = 0; cell <= 2 * reach; ++cell) {
      if (cells[cell] < 0) continue;
      const Wall& wall = walls_[static_cast<std::size_t>(cells[cell])];
      const Point2 away = in_map - wall.mean;
      const double away_m2 = dot(away, away);
      if (away_m2 >= least_m2) continue;
      least_m2 = away_m2;
      best = &wall;
    }
  }
  return best;
}

bool ScanFit::is_unknown(Point2 in_map) const {
  const Cell at = frame_.cell_at(in_map);
  return !frame_.contains(at) || wall_of_cell_[frame_.index(at)] == nothing_known;
}

ScanFit::Equations ScanFit::equations(std::span<const Point2> returns,
                                      const Pose2& map_from_robot) const {
  const double k2 = options_.outlier * options_.outlier;
  const Point2 ahead = unit_vector(map_from_robot.heading_rad);
  const Point2 left = left_of(ahead);
  Equations sum;
  for (const Point2 point : returns) {
    const Point2 turned = point.x_m * ahead + point.y_m * left;
    const Point2 in_map = map_from_robot.position() + turned;
    const Wall* const wall = nearest(in_map);
    if (!wall) {
      sum.cost += is_unknown(in_map) ? options_.unknown * k2 : k2;
      continue;
    }
    ++sum.matched;
    const auto [xx, xy, yy] = wall->information;
    const auto weighed = [xx = xx, xy = xy, yy = yy](Point2 p) {
      return Point2{xx * p.x_m + xy * p.y_m, xy * p.x_m + yy * p.y_m};
    };
    const Point2 off = in_map - wall->mean;
    const Point2 pull = weighed(off);
    const double fits = k2 / (k2 + dot(off, pull));
    sum.cost += fits * dot(off, pull);
    // How the return moves with the robot: ahead, to the left, turning.
    const std::array<Point2, 3> moves{ahead, left, left_of(turned)};
    for (std::size_t row = 0; row < 3; ++row) {
      sum.slope[row] -= fits * fits * dot(moves[row], pull);
      const Point2 weight = fits * fits * weighed(moves[row]);
      for (std::size_t column = row; column < 3; ++column) {
        sum.curvature[3 * row + column] += dot(weight, moves[column]);
      }
    }
  }
  for (const auto& [upper, lower] : {std::pair{1, 3}, {2, 6}, {5, 7}}) {
    sum.curvature[static_cast<std::size_t>(lower)] = sum.curvature[static_cast<std::size_t>(upper)];
  }
  return sum;
}

ScanFit::Fit ScanFit::fit(std::span<const Point2> returns, const Pose2& start,
                          const Pose2& by_odometry, const SmallMotion& odometry_information) const {
  Fit fit{.map_from_robot = start};
  for (int step = 0; step < options_.most_steps; ++step) {
    Equations at = equations(returns, fit.map_from_robot);
    const Pose2 back = inverse(fit.map_from_robot) * by_odometry;
    const SmallMotion off{back.x_m, back.y_m, back.heading_rad};
    // Wheels seldom slip far, but they may turn on the spot unheard.
    const auto& information = odometry_information;
    const double odd_turn = information[2] * off[2] * off[2];
    const double trust = odd_turn_cost / (odd_turn_cost + odd_turn);
    const SmallMotion prior{information[0], information[1], trust * trust * information[2]};
    for (std::size_t i = 0; i < 3; ++i) {
      at.curvature[4 * i] += prior[i];
      at.slope[i] += prior[i] * off[i];
    }
    fit.covariance = inverted(at.curvature);
    fit.cost = at.cost + information[0] * off[0] * off[0] + information[1] * off[1] * off[1] +
               trust * odd_turn;
    fit.matched = static_cast<double>(at.matched) / static_cast<double>(returns.size());
    SmallMotion move = {};
    for (std::size_t i = 0; i < 9; ++i) move[i / 3] += fit.covariance[i] * at.slope[i % 3];
    fit.map_from_robot = fit.map_from_robot * Pose2{move[0], move[1], move[2]};
    if (std::hypot(move[0], move[1]) < done_m && std::abs(move[2]) < done_rad) break;
  }
  return fit;
}

}  // namespace asterism
