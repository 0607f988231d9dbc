#include "metric/evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace asterism {
namespace {

/// The poses of a trajectory by their stamps.
class PosesByStamp {
 public:
  explicit PosesByStamp(const Trajectory& trajectory) {
    for (const TimedPose& pose : trajectory) poses_.push_back(&pose);
    // The poses lie one after another in the trajectory, so that addresses tell their order.
    const auto is_before = [](const TimedPose* a, const TimedPose* b) {
      return a->stamp_s != b->stamp_s ? a->stamp_s < b->stamp_s : a < b;
    };
    std::ranges::sort(poses_, is_before);
    const auto same = [](const TimedPose* a, const TimedPose* b) {
      return a->stamp_s == b->stamp_s;
    };
    const auto repeated = std::ranges::unique(poses_, same);
    poses_.erase(repeated.begin(), repeated.end());
  }

  /// The first pose of the trajectory at a stamp, nullptr if there is none.
  const TimedPose* find(double stamp_s) const {
    auto pose = std::ranges::lower_bound(poses_, stamp_s - same_stamp_s, {}, &TimedPose::stamp_s);
    const TimedPose* first = nullptr;
    for (; pose != poses_.end() && (*pose)->stamp_s <= stamp_s + same_stamp_s; ++pose)
      if (!first || *pose < first) first = *pose;
    return first;
  }

 private:
  std::vector<const TimedPose*> poses_;
};

Spread spread_of(std::span<const double> errors) {
  const auto count = static_cast<double>(errors.size());
  Spread spread;
  for (const double error : errors) spread.mean += error / count;
  double variance = 0;
  for (const double error : errors)
    variance += (error - spread.mean) * (error - spread.mean) / count;
  spread.standard_deviation = std::sqrt(variance);
  return spread;
}

}  // namespace

Pose2 rigid_fit(std::span<const Point2> points, std::span<const Point2> others) {
  const Point2 middle = mean(points);
  const Point2 other_middle = mean(others);
  // Turned by h, Σ |R(h) p - q|² is least where cos(h) Σ p·q + sin(h) Σ p×q is largest.
  double along = 0;
  double across = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    along += dot(points[i] - middle, others[i] - other_middle);
    across += cross(points[i] - middle, others[i] - other_middle);
  }
  const Pose2 turn{0, 0, std::atan2(across, along)};
  const Point2 shift = other_middle - turn * middle;
  return {shift.x_m, shift.y_m, turn.heading_rad};
}

std::optional<RelationErrors> relation_errors(const Trajectory& trajectory,
                                              std::span<const Relation> relations) {
  const PosesByStamp poses(trajectory);
  std::vector<double> translations_m;
  std::vector<double> rotations_rad;
  for (const Relation& relation : relations) {
    const TimedPose* const first = poses.find(relation.first_stamp_s);
    const TimedPose* const second = poses.find(relation.second_stamp_s);
    if (!first || !second) continue;
    const Pose2 estimated = inverse(first->layout_from_robot) * second->layout_from_robot;
    const Pose2 error = inverse(estimated) * relation.first_from_second;
    translations_m.push_back(norm(error.position()));
    rotations_rad.push_back(std::abs(error.heading_rad));
  }
  if (translations_m.empty()) return std::nullopt;
  return RelationErrors{translations_m.size(), spread_of(translations_m), spread_of(rotations_rad)};
}

std::optional<ReferenceErrors> reference_errors(const Trajectory& trajectory,
                                                const Trajectory& reference) {
  const PosesByStamp poses(trajectory);
  const PosesByStamp references(reference);
  std::vector<Point2> points, others;
  std::vector<double> turns_rad;
  for (const TimedPose& truth : reference) {
    const TimedPose* const pose = poses.find(truth.stamp_s);
    if (!pose || references.find(truth.stamp_s) != &truth) continue;
    points.push_back(pose->layout_from_robot.position());
    others.push_back(truth.layout_from_robot.position());
    turns_rad.push_back(truth.layout_from_robot.heading_rad - pose->layout_from_robot.heading_rad);
  }
  if (points.empty()) return std::nullopt;

  const auto count = static_cast<double>(points.size());
  const Pose2 fit = rigid_fit(points, others);
  double squares_m2 = 0, squares_rad2 = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point2 error = fit * points[i] - others[i];
    squares_m2 += dot(error, error);
    const double turn_rad = wrapped(turns_rad[i] - fit.heading_rad);
    squares_rad2 += turn_rad * turn_rad;
  }
  return ReferenceErrors{points.size(), std::sqrt(squares_m2 / count),
                         std::sqrt(squares_rad2 / count), fit};
}

}  // namespace asterism
