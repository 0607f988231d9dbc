#include "metric/exponential.hpp"

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/random.hpp"
#include "metric/layout_residual.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

constexpr double pi = std::numbers::pi;

SmallMotion any_motion(RandomEngine& random) {
  // Every other one turns so little that the series stand in for the quotients.
  const double most_rad = chance(0.5, random) ? 3.1 : 2e-4;
  return {between(-20, 20, random), between(-20, 20, random), between(-most_rad, most_rad, random)};
}

void check_same(const Pose2& a, const Pose2& b, double margin) {
  CHECK(a.x_m == Approx(b.x_m).margin(margin));
  CHECK(a.y_m == Approx(b.y_m).margin(margin));
  CHECK(std::abs(wrapped(a.heading_rad - b.heading_rad)) < margin);
}

}  // namespace

TEST_CASE("rigid motions are a group", "[metric][property]") {
  RandomEngine random(1);
  for (int i = 0; i < 1000; ++i) {
    const Pose2 a = exponential(any_motion(random));
    const Pose2 b = exponential(any_motion(random));
    const Pose2 c = exponential(any_motion(random));
    check_same((a * b) * c, a * (b * c), 1e-9);
    check_same(a * Pose2{}, a, 1e-12);
    check_same(a * inverse(a), Pose2{}, 1e-9);
    check_same(inverse(a) * a, Pose2{}, 1e-9);
    check_same(inverse(a * b), inverse(b) * inverse(a), 1e-9);
  }
}

TEST_CASE("the logarithm undoes the exponential", "[metric][property]") {
  RandomEngine random(2);
  for (int i = 0; i < 1000; ++i) {
    const SmallMotion motion = any_motion(random);
    const SmallMotion back = logarithm(exponential(motion));
    for (std::size_t k = 0; k < 3; ++k) CHECK(back[k] == Approx(motion[k]).margin(1e-8));
    const Pose2 pose{between(-9, 9, random), between(-9, 9, random), between(-pi, pi, random)};
    check_same(exponential(logarithm(pose)), pose, 1e-9);
  }
}

//      ( )     one unit of time at one turn a unit: a circle of radius 1, round to where it began
TEST_CASE("even motion is a circle, and a straight line where it does not turn", "[metric]") {
  check_same(exponential({pi, 0, pi}), {0, 2, pi}, 1e-12);
  check_same(exponential({pi / 2, 0, pi / 2}), {1, 1, pi / 2}, 1e-12);
  check_same(exponential({3, 4, 0}), {3, 4, 0}, 1e-12);
}

TEST_CASE("many small steps make the motion", "[metric][property]") {
  RandomEngine random(3);
  for (int i = 0; i < 50; ++i) {
    const SmallMotion motion = any_motion(random);
    constexpr int steps = 1024;
    const Pose2 step = exponential({motion[0] / steps, motion[1] / steps, motion[2] / steps});
    Pose2 pose;
    for (int k = 0; k < steps; ++k) pose = pose * step;
    check_same(pose, exponential(motion), 1e-8);
  }
}

// From a displacement that is nothing, as white as can be, a residual is the logarithm.
TEST_CASE("the logarithm's Jacobian is the slope measured", "[metric][property]") {
  RandomEngine random(4);
  const LayoutResidual residual(make_displacement({}, diagonal(1, 1)));
  constexpr double step = 1e-6;
  for (int i = 0; i < 500; ++i) {
    const SmallMotion motion = any_motion(random);
    const Pose2 reached = exponential(motion);
    const Point2 facing = unit_vector(reached.heading_rad);
    Eigen::Matrix3d coordinates_by_motion;
    coordinates_by_motion << facing.x_m, -facing.y_m, 0, facing.y_m, facing.x_m, 0, 0, 0, 1;
    const Eigen::Matrix3d jacobian = residual({}, reached).by_to * coordinates_by_motion;
    for (std::size_t column = 0; column < 3; ++column) {
      SmallMotion ahead{};
      SmallMotion back{};
      ahead[column] = step;
      back[column] = -step;
      const SmallMotion after = logarithm(exponential(motion) * exponential(ahead));
      const SmallMotion before = logarithm(exponential(motion) * exponential(back));
      for (std::size_t row = 0; row < 3; ++row) {
        const double slope = (after[row] - before[row]) / (2 * step);
        CHECK(jacobian(Eigen::Index(row), Eigen::Index(column)) ==
              Approx(slope).margin(2e-6).epsilon(1e-5));
      }
    }
  }
}

TEST_CASE("the adjoint is how a motion is seen from elsewhere", "[metric][property]") {
  RandomEngine random(5);
  for (int i = 0; i < 200; ++i) {
    const Pose2 pose = exponential(any_motion(random));
    const SmallMotion motion = any_motion(random);
    const Point2 facing = unit_vector(pose.heading_rad);
    const std::array matrix{facing.x_m, -facing.y_m, pose.y_m,   //
                            facing.y_m, facing.x_m,  -pose.x_m,  //
                            0.0,        0.0,         1.0};
    const SmallMotion seen = seen_from(pose, motion);
    for (std::size_t row = 0; row < 3; ++row) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += matrix[3 * row + k] * motion[k];
      CHECK(sum == Approx(seen[row]).margin(1e-9));
    }
    // The group law: pose · Exp(m) = Exp(Ad(pose) m) · pose.
    check_same(pose * exponential(motion), exponential(seen) * pose, 1e-8);
  }
}

}  // namespace asterism
