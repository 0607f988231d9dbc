#include "metric/wall_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "metric/exponential.hpp"

namespace asterism {
namespace {

// By turns: how far apart the same wall may be, as a share of the first, and within what radius.
// The walls near by come first: those far off move by more than a corridor is wide.
struct Turn {
  double reach;
  double radius_m;
};
constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr std::array kTurns{Turn{1, 3}, Turn{1, 6}, Turn{1, kFar}, Turn{0.5, kFar},
                            Turn{0.3, kFar}};
constexpr int kStepsAReach = 8;
constexpr double kSameWall = 0.8;  // cosine of the angle between the two
// What walls seem to tell along them, as a share of what they tell across, where they all run the
// same way and only the directions of their bits waver, being drawn in cells.
constexpr double kWavering = 0.02;
constexpr double kMatched_m = 0.2;
constexpr double kDone = 1e-5;

using RowMajor3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

double square(double x) { return x * x; }

// A pose that very many points are moved by.
class Motion {
 public:
  explicit Motion(const Pose2& a_from_b)
      : at_(a_from_b.position()), facing_(unit_vector(a_from_b.heading_rad)) {}

  Point2 turned(Point2 in_b) const {
    return {facing_.x_m * in_b.x_m - facing_.y_m * in_b.y_m,
            facing_.y_m * in_b.x_m + facing_.x_m * in_b.y_m};
  }
  Point2 turned_back(Point2 in_a) const { return {dot(facing_, in_a), cross(facing_, in_a)}; }
  Point2 moved(Point2 in_b) const { return at_ + turned(in_b); }

 private:
  Point2 at_;
  Point2 facing_;
};

bool is_within(double distance_m, Point2 a, Point2 b) {
  return dot(a - b, a - b) <= square(distance_m);
}

// Gauss-Newton's equations of small motions in the second frame.
struct Equations {
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
};

// Takes back what walls of one direction seem to tell along it.
void leave_open(Equations& walls) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> moves(walls.curvature.topLeftCorner<2, 2>());
  if (moves.eigenvalues()[0] > kWavering * moves.eigenvalues()[1]) return;
  Eigen::Matrix3d across = Eigen::Matrix3d::Identity();
  across.topLeftCorner<2, 2>() -=
      moves.eigenvectors().col(0) * moves.eigenvectors().col(0).transpose();
  walls.curvature = across * walls.curvature * across;
  walls.slope = across * walls.slope;
}

Equations equations(const PlaceWalls& first, const PlaceWalls& second, const Pose2& pose,
                    double reach_m, double radius_m, double wall_m) {
  Equations sum;
  const Motion first_from_second(pose);
  for (const WallPiece& piece : second.pieces()) {
    if (!is_within(radius_m, piece.point, {})) continue;
    const Point2 point = first_from_second.moved(piece.point);
    const WallPiece* const near = first.nearest(point);
    if (near == nullptr || !is_within(reach_m, near->point, point)) continue;
    if (std::abs(dot(first_from_second.turned(piece.normal), near->normal)) < kSameWall) continue;
    const double off_m = dot(near->normal, point - near->point);
    // Half as far as the reach, a bit of wall counts half.
    const double information = 1 / square(wall_m) / (1 + square(2 * off_m / reach_m));
    const Point2 normal = first_from_second.turned_back(near->normal);
    const Eigen::Vector3d jacobian(normal.x_m, normal.y_m, cross(piece.point, normal));
    sum.curvature += information * jacobian * jacobian.transpose();
    sum.slope -= information * off_m * jacobian;
  }
  leave_open(sum);
  return sum;
}

struct Share {
  std::size_t matched = 0;
  std::size_t known = 0;
};

// Of the walls of one map, where the other knows its way about, how many the other has.
Share matched(const PlaceWalls& of, const PlaceWalls& by, const Pose2& by_from_of) {
  Share share;
  const Motion motion(by_from_of);
  for (const WallPiece& piece : of.pieces()) {
    const Point2 point = motion.moved(piece.point);
    if (!by.is_known(point)) continue;
    ++share.known;
    const WallPiece* const near = by.nearest(point);
    if (near != nullptr && is_within(kMatched_m, near->point, point)) ++share.matched;
  }
  return share;
}

}  // namespace

WallFit fit_walls(const PlaceWalls& first, const PlaceWalls& second, const Pose2& start,
                  const PoseCovariance& information, const WallFitOptions& options) {
  const Eigen::Matrix3d of_start = Eigen::Map<const RowMajor3>(information.data());
  WallFit fit{.first_from_second = start};
  Pose2& pose = fit.first_from_second;
  Equations walls;
  for (const auto& [reach, radius_m] : kTurns) {
    for (int step = 0; step < kStepsAReach; ++step) {
      walls = equations(first, second, pose, reach * options.reach_m, radius_m, options.wall_m);
      const SmallMotion away = logarithm(inverse(start) * pose);
      const Eigen::Vector3d motion =
          (walls.curvature + of_start)
              .ldlt()
              .solve(walls.slope - of_start * Eigen::Map<const Eigen::Vector3d>(away.data()));
      pose = pose * exponential({motion[0], motion[1], motion[2]});
      if (motion.norm() < kDone) break;
    }
  }
  Eigen::Map<RowMajor3>{fit.information.data()} = walls.curvature;
  const Share ours = matched(second, first, pose);
  const Share theirs = matched(first, second, inverse(pose));
  fit.matched_walls = static_cast<double>(ours.matched + theirs.matched) /
                      static_cast<double>(std::max<std::size_t>(1, ours.known + theirs.known));
  return fit;
}

}  // namespace asterism
