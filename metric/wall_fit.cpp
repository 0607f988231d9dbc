#include "metric/wall_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "metric/exponential.hpp"

namespace asterism {
namespace {

constexpr std::array kReaches{1.0, 0.5, 0.3};  // shares of the first, by turns
constexpr int kStepsAReach = 8;
constexpr double kSameWall = 0.8;  // cosine of the angle between the two
constexpr double kMatched_m = 0.2;
constexpr double kDone = 1e-5;

using RowMajor3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

double square(double x) { return x * x; }

// Gauss-Newton's equations of small motions in the second frame.
struct Equations {
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
};

Equations equations(const PlaceWalls& first, const PlaceWalls& second, const Pose2& pose,
                    double reach_m, double wall_m) {
  Equations sum;
  const Pose2 turn{0, 0, pose.heading_rad};
  const Pose2 turn_back = inverse(turn);
  for (const WallPiece& piece : second.pieces()) {
    const Point2 point = pose * piece.point;
    const WallPiece* const near = first.nearest(point);
    if (near == nullptr || norm(near->point - point) > reach_m) continue;
    if (std::abs(dot(turn * piece.normal, near->normal)) < kSameWall) continue;
    const double off_m = dot(near->normal, point - near->point);
    // Half as far as the reach, a bit of wall counts half.
    const double information = 1 / square(wall_m) / (1 + square(2 * off_m / reach_m));
    const Point2 normal = turn_back * near->normal;
    const Eigen::Vector3d jacobian(normal.x_m, normal.y_m, cross(piece.point, normal));
    sum.curvature += information * jacobian * jacobian.transpose();
    sum.slope -= information * off_m * jacobian;
  }
  return sum;
}

struct Share {
  std::size_t matched = 0;
  std::size_t known = 0;
};

// Of the walls of one map, where the other knows its way about, how many the other has.
Share matched(const PlaceWalls& of, const PlaceWalls& by, const Pose2& by_from_of) {
  Share share;
  for (const WallPiece& piece : of.pieces()) {
    const Point2 point = by_from_of * piece.point;
    if (!by.is_known(point)) continue;
    ++share.known;
    const WallPiece* const near = by.nearest(point);
    if (near != nullptr && norm(near->point - point) <= kMatched_m) ++share.matched;
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
  for (const double share : kReaches) {
    for (int step = 0; step < kStepsAReach; ++step) {
      walls = equations(first, second, pose, share * options.reach_m, options.wall_m);
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
