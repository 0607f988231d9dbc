#include "metric/wall_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/squared.hpp"
#include "metric/exponential.hpp"
#include "metric/gauss_newton.hpp"

namespace asterism {
namespace {

// By turns: how far apart the same wall may be, as a share of the first, and within what radius.
// The walls near by come first: those far off move by more than a corridor is wide.
struct Turn {
  double reach;
  double radius_m;
};
constexpr double far_m = std::numeric_limits<double>::infinity();
constexpr std::array turns{Turn{1, 3}, Turn{1, 6}, Turn{1, far_m}, Turn{0.5, far_m},
                           Turn{0.3, far_m}};
constexpr int steps_a_turn = 8;
constexpr double same_wall_cosine = 0.8;  // cosine of the angle between the two
// What walls seem to tell along them, as a share of what they tell across, where they all run the
// same way and only the directions of their bits waver, being drawn in cells.
constexpr double wavering_share = 0.02;
constexpr double matched_m = 0.2;
constexpr double done_motion = 1e-5;

// A pose that very many points are moved by.
class Motion {
 public:
  explicit Motion(const Pose2& a_from_b)
      : at_(a_from_b.position()), facing_(unit_vector(a_from_b.heading_rad)) {}

  Point2 facing() const { return facing_; }
  Point2 moved(Point2 in_b) const { return at_ + turned(facing_, in_b); }

 private:
  Point2 at_;
  Point2 facing_;
};

bool is_within(double distance_m, Point2 a, Point2 b) {
  return dot(a - b, a - b) <= squared(distance_m);
}

// Takes back what walls of one direction seem to tell along it.
void leave_open(GaussNewton& walls) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> moves(walls.curvature.topLeftCorner<2, 2>());
  if (moves.eigenvalues()[0] > wavering_share * moves.eigenvalues()[1]) return;
  Eigen::Matrix3d across = Eigen::Matrix3d::Identity();
  across.topLeftCorner<2, 2>() -=
      moves.eigenvectors().col(0) * moves.eigenvectors().col(0).transpose();
  walls.curvature = across * walls.curvature * across;
  walls.slope = across * walls.slope;
}

GaussNewton equations(const PlaceWalls& first, const PlaceWalls& second, const Pose2& pose,
                      double reach_m, double radius_m, double wall_m) {
  GaussNewton sum;
  const Motion first_from_second(pose);
  for (const WallPiece& piece : second.pieces()) {
    if (!is_within(radius_m, piece.point, {})) continue;
    const Point2 point = first_from_second.moved(piece.point);
    const WallPiece* const near = first.nearest(point);
    if (near == nullptr || !is_within(reach_m, near->point, point)) continue;
    if (std::abs(dot(turned(first_from_second.facing(), piece.normal), near->normal)) <
        same_wall_cosine)
      continue;
    const double off_m = dot(near->normal, point - near->point);
    // Half as far as the reach, a bit of wall counts half.
    const double information = 1 / squared(wall_m) / (1 + squared(2 * off_m / reach_m));
    const Point2 normal = turned_back(first_from_second.facing(), near->normal);
    sum.add({normal.x_m, normal.y_m, cross(piece.point, normal)}, off_m, information);
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
    if (near != nullptr && is_within(matched_m, near->point, point)) ++share.matched;
  }
  return share;
}

}  // namespace

WallFit fit_walls(const PlaceWalls& first, const PlaceWalls& second, const Pose2& start,
                  const PoseCovariance& information, const WallFitOptions& options) {
  const Matrix3 of_start = matrix(information);
  WallFit fit{.first_from_second = start};
  Pose2& pose = fit.first_from_second;
  GaussNewton walls;
  for (const auto& [reach, radius_m] : turns) {
    for (int step = 0; step < steps_a_turn; ++step) {
      walls = equations(first, second, pose, reach * options.reach_m, radius_m, options.wall_m);
      const SmallMotion away = logarithm(inverse(start) * pose);
      const Eigen::Vector3d motion =
          (walls.curvature + of_start)
              .ldlt()
              .solve(walls.slope - of_start * Eigen::Map<const Eigen::Vector3d>(away.data()));
      pose = pose * exponential({motion[0], motion[1], motion[2]});
      if (motion.norm() < done_motion) break;
    }
  }
  fit.information = numbers(walls.curvature);
  const Share ours = matched(second, first, pose);
  const Share theirs = matched(first, second, inverse(pose));
  fit.matched_walls = static_cast<double>(ours.matched + theirs.matched) /
                      static_cast<double>(std::max<std::size_t>(1, ours.known + theirs.known));
  return fit;
}

}  // namespace asterism
