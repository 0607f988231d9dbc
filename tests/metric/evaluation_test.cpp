#include "metric/evaluation.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

constexpr double pi = std::numbers::pi;

Pose2 any_pose(RandomEngine& random) {
  return {between(-20, 20, random), between(-20, 20, random), between(-pi, pi, random)};
}

/// A drive with stamps as a log has them: in steps of a tenth, one in ten a little back.
Trajectory any_drive(std::size_t poses, RandomEngine& random) {
  Trajectory drive;
  double stamp_s = 1e9;
  for (std::size_t i = 0; i < poses; ++i)
    drive.push_back({stamp_s += chance(0.1, random) ? -0.25 : 0.1, any_pose(random)});
  return drive;
}

Trajectory moved(Trajectory drive, const Pose2& other_from_layout) {
  for (TimedPose& pose : drive) pose.layout_from_robot = other_from_layout * pose.layout_from_robot;
  return drive;
}

double squared_distance(const Pose2& motion, const std::vector<Point2>& points,
                        const std::vector<Point2>& others) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point2 apart = motion * points[i] - others[i];
    sum += dot(apart, apart);
  }
  return sum;
}

/// The least by trying: every turn, finer and finer, each with the shift that joins the middles.
double least_squared_distance(const std::vector<Point2>& points,
                              const std::vector<Point2>& others) {
  Point2 middle, other_middle;
  const double share = 1 / static_cast<double>(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    middle = middle + share * points[i];
    other_middle = other_middle + share * others[i];
  }
  const auto at = [&](double heading_rad) {
    const Point2 shift = other_middle - Pose2{0, 0, heading_rad} * middle;
    return squared_distance({shift.x_m, shift.y_m, heading_rad}, points, others);
  };
  double best_rad = 0, step_rad = pi;
  for (int round = 0; round < 12; ++round) {
    const double centre_rad = best_rad;
    for (int i = -50; i <= 50; ++i)
      if (const double rad = centre_rad + i * step_rad / 50; at(rad) < at(best_rad)) best_rad = rad;
    step_rad /= 20;
  }
  return at(best_rad);
}

}  // namespace

TEST_CASE("a rigid fit finds the motion that points made", "[metric][property]") {
  RandomEngine random(1);
  for (int i = 0; i < 200; ++i) {
    const Pose2 motion = any_pose(random);
    std::vector<Point2> points, others;
    for (std::size_t k = 0; k < 2 + below(9, random); ++k) {
      points.push_back(any_pose(random).position());
      others.push_back(motion * points.back());
    }
    const Pose2 fit = rigid_fit(points, others);
    CHECK(norm(fit.position() - motion.position()) < 1e-9);
    CHECK(std::abs(wrapped(fit.heading_rad - motion.heading_rad)) < 1e-9);
  }
}

TEST_CASE("no motion brings points nearer than the rigid fit", "[metric][property]") {
  RandomEngine random(2);
  for (int i = 0; i < 50; ++i) {
    std::vector<Point2> points, others;
    for (std::size_t k = 0; k < 2 + below(9, random); ++k) {
      points.push_back(any_pose(random).position());
      others.push_back(any_pose(random).position());
    }
    const double least = squared_distance(rigid_fit(points, others), points, others);
    CHECK(least == Approx(least_squared_distance(points, others)).epsilon(1e-6));
    for (int k = 0; k < 20; ++k) CHECK(least <= squared_distance(any_pose(random), points, others));
  }
}

TEST_CASE("a mirror image is no rigid motion", "[metric]") {
  const std::vector<Point2> points{{1, 0}, {0, 2}, {-3, 1}};
  std::vector<Point2> mirrored;
  for (const Point2 p : points) mirrored.push_back({p.x_m, -p.y_m});
  CHECK(squared_distance(rigid_fit(points, mirrored), points, mirrored) > 1);
  const Pose2 shift = rigid_fit(std::span(points).first(1), std::span(mirrored).last(1));
  CHECK(shift == Pose2{-4, -1, 0});  // one point says nothing of turns
}

TEST_CASE("a trajectory moved rigidly has no error against what it was", "[metric][property]") {
  RandomEngine random(3);
  for (int i = 0; i < 50; ++i) {
    const Trajectory drive = any_drive(3 + below(60, random), random);
    const Pose2 motion = any_pose(random);
    const auto errors = reference_errors(moved(drive, motion), drive);
    REQUIRE(errors);
    CHECK(errors->position_rmse_m < 1e-9);
    CHECK(errors->heading_rmse_rad < 1e-9);
    CHECK(norm((motion * errors->reference_from_layout).position()) < 1e-9);
  }
}

//   +---x---+      four corners of a square of 2 m, the estimates 0.3 m farther out along both
//   |       |      diagonals: the fit is none, each error 0.3 m
//   +-------+
TEST_CASE("known errors give the known root mean square", "[metric]") {
  Trajectory estimate, reference;
  for (int corner = 0; corner < 4; ++corner) {
    const double direction_rad = pi / 4 + corner * pi / 2;
    const Point2 at = std::sqrt(2) * unit_vector(direction_rad);
    const Point2 off = at + 0.3 * unit_vector(direction_rad);
    reference.push_back({1. * corner, {at.x_m, at.y_m, 3}});
    estimate.push_back({1. * corner, {off.x_m, off.y_m, corner % 2 == 0 ? -3. : 3.}});
  }
  const auto errors = reference_errors(estimate, reference);
  REQUIRE(errors);
  CHECK(errors->matched == 4);
  CHECK(errors->position_rmse_m == Approx(0.3));
  CHECK(errors->heading_rmse_rad == Approx((2 * pi - 6) / std::sqrt(2)));
}

TEST_CASE("known errors of relations give the known mean and deviation", "[metric]") {
  const Trajectory estimate{{1, {5, 5, pi / 2}}, {2, {5, 7, pi}}, {3, {4, 7, pi}}};
  const std::vector<Relation> relations{{1, 2, {2, 0.1, pi / 2}},  // 0.1 m, nothing
                                        {2, 3, {1.3, 0, 0.4}},     // 0.3 m, 0.4 rad
                                        {3, 2, {-1, 0, -0.2}},     // nothing, 0.2 rad
                                        {2, 2.5, {100, 100, 2}}};  // no such stamp
  const auto errors = relation_errors(estimate, relations);
  REQUIRE(errors);
  CHECK(errors->matched == 3);
  CHECK(errors->translation_m.mean == Approx(0.4 / 3));
  CHECK(errors->translation_m.standard_deviation == Approx(std::sqrt(0.1 / 3 - 0.16 / 9)));
  CHECK(errors->rotation_rad.mean == Approx(0.2));
  CHECK(errors->rotation_rad.standard_deviation == Approx(std::sqrt(0.2 / 3 - 0.04)));
}

TEST_CASE("relations of a drive itself have no error, wherever it lies", "[metric][property]") {
  RandomEngine random(4);
  for (int i = 0; i < 50; ++i) {
    const Trajectory drive = any_drive(40, random);
    std::vector<Relation> relations;
    for (int k = 0; k < 30; ++k) {
      // Stamps may repeat: the first pose of a stamp is the one that is meant.
      const auto first_of = [&](double stamp_s) {
        for (const TimedPose& pose : drive)
          if (std::abs(pose.stamp_s - stamp_s) <= same_stamp_s) return pose;
        return drive.front();
      };
      const TimedPose a = first_of(drive[below(40, random)].stamp_s);
      const TimedPose b = first_of(drive[below(40, random)].stamp_s);
      relations.push_back(
          {a.stamp_s, b.stamp_s, inverse(a.layout_from_robot) * b.layout_from_robot});
    }
    const auto errors = relation_errors(moved(drive, any_pose(random)), relations);
    REQUIRE(errors);
    CHECK(errors->matched == 30);
    CHECK(errors->translation_m.mean < 1e-9);
    CHECK(errors->rotation_rad.mean < 1e-9);
  }
}

TEST_CASE("stamps match to the microsecond, the first of a file before later ones", "[metric]") {
  const Trajectory reference{{1000, {0, 0, 0}}, {1000, {9, 9, 0}}, {1001, {1, 0, 0}}};
  const Trajectory estimate{{1001.0000005, {1, 0, 0}},
                            {999.9999995, {0, 0, 0}},
                            {1000, {7, 7, 0}},
                            {1001, {7, 7, 0}},
                            {1000.5, {8, 8, 0}}};
  const auto errors = reference_errors(estimate, reference);
  REQUIRE(errors);
  CHECK(errors->matched == 2);
  CHECK(errors->position_rmse_m < 1e-12);
  CHECK_FALSE(reference_errors({{1, {}}}, {{1.00001, {}}}));
  CHECK_FALSE(relation_errors({{1, {}}}, std::vector<Relation>{{1, 2, {}}}));
}

}  // namespace asterism
