#include "metric/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

constexpr double pi = std::numbers::pi;
// What some hundred sums and turns of numbers up to a hundred lose to rounding.
constexpr double rounding = 1e-9;

Pose2 any_pose(RandomEngine& random) {
  return {between(-30, 30, random), between(-30, 30, random), between(-pi, pi, random)};
}

// A winding drive, some 0.1 m a scan, which stands still now and then.
std::vector<Pose2> any_drive(std::size_t scans, RandomEngine& random) {
  std::vector<Pose2> poses{any_pose(random)};
  double turn_rad = 0;
  while (poses.size() < scans) {
    if (chance(0.1, random)) turn_rad = between(-0.2, 0.2, random);
    const double step_m = chance(0.2, random) ? 0 : between(0.05, 0.15, random);
    poses.push_back(poses.back() * Pose2{step_m, 0, turn_rad});
  }
  return poses;
}

std::vector<LocalPose> as_driven(const std::vector<Pose2>& poses) {
  std::vector<LocalPose> driven;
  for (const Pose2& pose : poses) driven.push_back({0.2 * double(driven.size()), pose});
  return driven;
}

// Every so many scans, somewhere near where the scan was.
std::vector<Anchor> any_anchors(const std::vector<Pose2>& poses, std::size_t every,
                                RandomEngine& random) {
  std::vector<Anchor> anchors;
  for (std::size_t scan = every / 2; scan < poses.size(); scan += every) {
    const Pose2 off{normal(random), normal(random), 0.2 * normal(random)};
    anchors.push_back({scan, poses[scan] * off});
  }
  return anchors;
}

std::vector<LocalPose> moved(const Pose2& by, std::vector<LocalPose> driven) {
  for (LocalPose& pose : driven) pose.map_from_robot = by * pose.map_from_robot;
  return driven;
}

std::vector<Anchor> moved(const Pose2& by, std::vector<Anchor> anchors) {
  for (Anchor& anchor : anchors) anchor.layout_from_robot = by * anchor.layout_from_robot;
  return anchors;
}

Pose2 mirrored(const Pose2& pose) { return {pose.x_m, -pose.y_m, wrapped(-pose.heading_rad)}; }

double apart(const Pose2& a, const Pose2& b) {
  return norm(a.position() - b.position()) + std::abs(wrapped(a.heading_rad - b.heading_rad));
}

// How far apart two fits are at most. `of_b` maps the poses of b to those of a.
template <class F>
double most_apart(const Trajectory& a, const Trajectory& b, F&& of_b) {
  REQUIRE(a.size() == b.size());
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, apart(a[i].layout_from_robot, of_b(b[i].layout_from_robot)));
  }
  return most;
}

double mean_square_m2(const Trajectory& fitted, const std::vector<Pose2>& truth) {
  double sum_m2 = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Point2 off = fitted[i].layout_from_robot.position() - truth[i].position();
    sum_m2 += dot(off, off);
  }
  return sum_m2 / double(truth.size());
}

}  // namespace

TEST_CASE("a trajectory is exact at its anchors and keeps the stamps", "[metric][property]") {
  RandomEngine random(1);
  for (int i = 0; i < 50; ++i) {
    const std::vector<Pose2> poses = any_drive(200, random);
    std::vector<LocalPose> driven = as_driven(poses);
    driven[70].stamp_s = 3;  // stamps may run backwards
    const std::vector<Anchor> anchors = any_anchors(poses, 30, random);
    const Trajectory fitted = fit_trajectory(driven, anchors);
    REQUIRE(fitted.size() == driven.size());
    for (const Anchor& anchor : anchors) {
      CHECK(fitted[anchor.scan].layout_from_robot == anchor.layout_from_robot);
    }
    for (std::size_t k = 0; k < driven.size(); ++k) {
      CHECK(fitted[k].stamp_s == driven[k].stamp_s);
    }
  }
}

TEST_CASE("before the first anchor and after the last the way is moved rigidly", "[metric]") {
  RandomEngine random(2);
  const std::vector<Pose2> poses = any_drive(200, random);
  const std::vector<Anchor> anchors{{60, any_pose(random)}, {140, any_pose(random)}};
  const Trajectory fitted = fit_trajectory(as_driven(poses), anchors);
  const auto check_rigid = [&](std::size_t anchor, std::size_t scan) {
    const Pose2 driven = inverse(poses[anchor]) * poses[scan];
    CHECK(apart(inverse(fitted[anchor].layout_from_robot) * fitted[scan].layout_from_robot,
                driven) < rounding);
  };
  for (std::size_t scan = 0; scan < 60; ++scan) check_rigid(60, scan);
  for (std::size_t scan = 141; scan < 200; ++scan) check_rigid(140, scan);
}

TEST_CASE("a way that agrees with its anchors is not changed", "[metric][property]") {
  RandomEngine random(3);
  for (int i = 0; i < 50; ++i) {
    const std::vector<Pose2> poses = any_drive(200, random);
    const Pose2 layout_from_map = any_pose(random);
    std::vector<Anchor> anchors;
    for (const std::size_t scan : {0U, 50U, 51U, 120U, 199U}) {
      anchors.push_back({scan, layout_from_map * poses[scan]});
    }
    const Trajectory fitted = fit_trajectory(as_driven(poses), anchors);
    for (std::size_t k = 0; k < poses.size(); ++k) {
      CHECK(apart(fitted[k].layout_from_robot, layout_from_map * poses[k]) < rounding);
    }
  }
}

TEST_CASE("a trajectory turns, shifts and mirrors with its layout and with its map",
          "[metric][property]") {
  RandomEngine random(4);
  for (int i = 0; i < 50; ++i) {
    const std::vector<Pose2> poses = any_drive(200, random);
    const std::vector<LocalPose> driven = as_driven(poses);
    const std::vector<Anchor> anchors = any_anchors(poses, 40, random);
    const Trajectory fitted = fit_trajectory(driven, anchors);

    const Pose2 by = any_pose(random);
    CHECK(most_apart(fit_trajectory(driven, moved(by, anchors)), fitted,
                     [&](const Pose2& pose) { return by * pose; }) < rounding);
    CHECK(most_apart(fit_trajectory(moved(by, driven), anchors), fitted,
                     [](const Pose2& pose) { return pose; }) < rounding);

    std::vector<LocalPose> mirrored_driven = driven;
    for (LocalPose& pose : mirrored_driven) pose.map_from_robot = mirrored(pose.map_from_robot);
    std::vector<Anchor> mirrored_anchors = anchors;
    for (Anchor& a : mirrored_anchors) a.layout_from_robot = mirrored(a.layout_from_robot);
    CHECK(most_apart(fit_trajectory(mirrored_driven, mirrored_anchors), fitted, mirrored) <
          rounding);
  }
}

TEST_CASE("a way driven backwards has the same poses", "[metric][property]") {
  RandomEngine random(5);
  for (int i = 0; i < 50; ++i) {
    const std::vector<Pose2> poses = any_drive(200, random);
    std::vector<LocalPose> driven = as_driven(poses);
    std::vector<Anchor> anchors = any_anchors(poses, 40, random);
    Trajectory fitted = fit_trajectory(driven, anchors);
    std::ranges::reverse(fitted);

    // The robot may have turned round for it.
    const Pose2 about{0, 0, chance(0.5, random) ? pi : 0};
    std::ranges::reverse(driven);
    for (LocalPose& pose : driven) pose.map_from_robot = pose.map_from_robot * about;
    std::ranges::reverse(anchors);
    for (Anchor& anchor : anchors) {
      anchor = {driven.size() - 1 - anchor.scan, anchor.layout_from_robot * about};
    }
    CHECK(most_apart(fit_trajectory(driven, anchors), fitted,
                     [&](const Pose2& pose) { return pose * about; }) < rounding);
  }
}

//   start o--------------+     Out and back: by how far the ends were off no pose is moved farther,
//     end o--------------+     though start and end nearly coincide.
TEST_CASE("a travel that ends where it began is not torn apart", "[metric]") {
  std::vector<Pose2> poses;
  for (int i = 0; i <= 100; ++i) poses.push_back({0.2 * i, 0, 0});
  for (int i = 100; i >= 0; --i) poses.push_back({0.2 * i, 1e-3, pi});
  const Pose2 end{0.1, 0.3, pi};
  const std::vector<Anchor> anchors{{0, poses.front()}, {poses.size() - 1, end}};
  const Trajectory fitted = fit_trajectory(as_driven(poses), anchors);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    CHECK(norm(fitted[i].layout_from_robot.position() - poses[i].position()) < 0.33);
  }
}

//   o---___     ___---o     Ends that are off in heading alone, by 0.1 rad, bow a straight way of
//          -----            20 m by an eighth of what that makes, and shift none of it far.
TEST_CASE("a straight travel bows no more than its heading was off", "[metric]") {
  std::vector<Pose2> poses;
  for (int i = 0; i <= 100; ++i) poses.push_back({0.2 * i, 0, 0});
  const std::vector<Anchor> anchors{{0, {}}, {100, {20, 0, 0.1}}};
  const Trajectory fitted = fit_trajectory(as_driven(poses), anchors);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Pose2& pose = fitted[i].layout_from_robot;
    CHECK(norm(pose.position() - poses[i].position()) < 0.26);
    CHECK(pose.y_m <= rounding);
    CHECK(pose.heading_rad == Approx(0.1 * poses[i].x_m / 20).margin(rounding));
  }
  CHECK(fitted[50].layout_from_robot.y_m == Approx(-20 * 0.1 / 8).epsilon(0.01));
}

TEST_CASE("where the robot never moved, what is off is spread over its scans", "[metric]") {
  const std::vector<LocalPose> driven = as_driven(std::vector<Pose2>(5, Pose2{1, 2, 0}));
  const std::vector<Anchor> anchors{{0, {}}, {4, {0.4, 0, 0.8}}};
  const Trajectory fitted = fit_trajectory(driven, anchors);
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    CHECK(apart(fitted[i].layout_from_robot, {0.1 * double(i), 0, 0.2 * double(i)}) < rounding);
  }
}

// Of wheels with noise in every step and a wrong scale, as most are.
TEST_CASE("true anchors bring the way nearer to the truth", "[metric][property]") {
  RandomEngine random(6);
  double rigid_m2 = 0;
  double fitted_m2 = 0;
  int farther = 0;
  constexpr int drives = 200;
  for (int i = 0; i < drives; ++i) {
    const std::vector<Pose2> truth = any_drive(300, random);
    const double scale = 1 + 0.03 * normal(random);
    std::vector<Pose2> driven{{}};
    for (std::size_t k = 1; k < truth.size(); ++k) {
      const Pose2 step = inverse(truth[k - 1]) * truth[k];
      driven.push_back(driven.back() * Pose2{scale * step.x_m + 0.005 * normal(random),
                                             step.y_m + 0.005 * normal(random),
                                             step.heading_rad + 0.005 * normal(random)});
    }
    const std::vector<Anchor> anchors{{0, truth[0]}, {150, truth[150]}, {299, truth[299]}};
    const Trajectory rigid = fit_trajectory(as_driven(driven), {anchors.data(), 1});
    const Trajectory fitted = fit_trajectory(as_driven(driven), anchors);
    const double before_m2 = mean_square_m2(rigid, truth);
    const double after_m2 = mean_square_m2(fitted, truth);
    rigid_m2 += before_m2;
    fitted_m2 += after_m2;
    if (after_m2 > before_m2) ++farther;
  }
  CHECK(std::sqrt(fitted_m2) < 0.3 * std::sqrt(rigid_m2));
  CHECK(farther <= drives / 20);
}

TEST_CASE("anchors that are no anchors are refused", "[metric]") {
  const std::vector<LocalPose> driven = as_driven(std::vector<Pose2>(5));
  const auto message = [&](const std::vector<Anchor>& anchors) {
    try {
      fit_trajectory(driven, anchors);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  CHECK(message({}) == "trajectory: found no anchor; expected one or more");
  CHECK(message({{5, {}}}) == "trajectory: found anchor at scan 5; expected less than 5");
  CHECK(message({{3, {}}, {3, {}}}) == "trajectory: found anchor at scan 3; expected more than 3");
  CHECK(message({{0, {}}, {4, {}}}) == "none");
}

}  // namespace asterism
