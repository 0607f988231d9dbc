#include "core/pose_covariance.hpp"

#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "core/trace.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

constexpr double pi = std::numbers::pi;

Pose2 any_pose(RandomEngine& random) {
  return {between(-20, 20, random), between(-20, 20, random), between(-pi, pi, random)};
}

// Any covariance: that of three random mixtures.
PoseCovariance any_covariance(RandomEngine& random) {
  PoseCovariance result{};
  for (int mixture = 0; mixture < 3; ++mixture) {
    const SmallMotion m{normal(random), normal(random), normal(random)};
    for (std::size_t i = 0; i < 9; ++i) result[i] += m[i / 3] * m[i % 3];
  }
  return result;
}

}  // namespace

TEST_CASE("a small motion in another frame moves the world alike", "[core][property]") {
  RandomEngine random(1);
  constexpr double small = 1e-6;  // so that its square, which is left out, does not show
  for (int i = 0; i < 100; ++i) {
    const Pose2 a_from_b = any_pose(random);
    const SmallMotion in_b{small * normal(random), small * normal(random), small * normal(random)};
    const auto [x_m, y_m, turn_rad] = seen_from(a_from_b, in_b);
    const Pose2 moved = a_from_b * Pose2{in_b[0], in_b[1], in_b[2]} * inverse(a_from_b);
    CHECK(x_m == Approx(moved.x_m).margin(1e-9));
    CHECK(y_m == Approx(moved.y_m).margin(1e-9));
    CHECK(turn_rad == Approx(moved.heading_rad).margin(1e-12));
  }
}

//   b ----10 m---> c    a heading off by 0.1 at b is 1 m to the side at c
TEST_CASE("a heading error reaches as far as the lever is long", "[core]") {
  const PoseCovariance at_b{0, 0, 0, 0, 0, 0, 0, 0, 0.01};
  const PoseCovariance at_c = seen_from(inverse(Pose2{10, 0, 0}), at_b);
  CHECK(at_c[0] == Approx(0).margin(1e-12));
  CHECK(at_c[4] == Approx(1));
  CHECK(at_c[5] == Approx(0.1));
  CHECK(at_c[8] == Approx(0.01));
}

TEST_CASE("a covariance goes with its motions", "[core][property]") {
  RandomEngine random(2);
  for (int i = 0; i < 100; ++i) {
    const Pose2 pose = any_pose(random);
    const SmallMotion m{normal(random), normal(random), normal(random)};
    PoseCovariance of_m{};
    for (std::size_t k = 0; k < 9; ++k) of_m[k] = m[k / 3] * m[k % 3];
    const SmallMotion seen = seen_from(pose, m);
    const PoseCovariance of_seen = seen_from(pose, of_m);
    for (std::size_t k = 0; k < 9; ++k) {
      CHECK(of_seen[k] == Approx(seen[k / 3] * seen[k % 3]).margin(1e-9));
    }
  }
}

TEST_CASE("a covariance stays one, and comes back the same", "[core][property]") {
  RandomEngine random(3);
  for (int i = 0; i < 100; ++i) {
    const Pose2 pose = any_pose(random);
    const PoseCovariance covariance = any_covariance(random);
    const PoseCovariance there = seen_from(pose, covariance);
    CHECK(is_covariance(there));
    const PoseCovariance back = seen_from(inverse(pose), there);
    for (std::size_t k = 0; k < 9; ++k) CHECK(back[k] == Approx(covariance[k]).margin(1e-9));
  }
}

}  // namespace asterism
