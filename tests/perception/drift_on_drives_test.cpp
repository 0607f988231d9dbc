#include <algorithm>
#include <cmath>
#include <vector>

#include "core/trace.hpp"
#include "perception/local_perceptual_map.hpp"
#include "perception/localiser.hpp"
#include "simulation/drive.hpp"
#include "simulation/office_building.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

constexpr double bound_of_95_percent = 7.815;  // of χ² with three degrees of freedom

struct Error {
  double position_m = 0;
  double heading_rad = 0;
  double chi_squared = 0;
};

// eᵀ C⁻¹ e, by Cholesky's C = L Lᵀ.
double chi_squared(const SmallMotion& error, const PoseCovariance& covariance) {
  PoseCovariance lower{};
  SmallMotion white{};
  double sum = 0;
  for (std::size_t row = 0; row < 3; ++row) {
    white[row] = error[row];
    for (std::size_t column = 0; column <= row; ++column) {
      double rest = covariance[3 * row + column];
      for (std::size_t k = 0; k < column; ++k) rest -= lower[3 * row + k] * lower[3 * column + k];
      lower[3 * row + column] = row == column ? std::sqrt(rest) : rest / lower[4 * column];
      if (column < row) white[row] -= lower[3 * row + column] * white[column];
    }
    white[row] /= lower[4 * row];
    sum += white[row] * white[row];
  }
  return sum;
}

// What the localiser makes of the travels of a drive through an office, people walking about and
// the wheels 5 % and 5° a travel off.
std::vector<Error> travels(std::uint64_t seed) {
  RandomEngine random(seed);
  const Building building = office_building({.columns = 3, .rows = 3}, random);
  const Route route = random_route(building.world, {.travels = 4}, random);
  Drive drive(building, route, {}, random());
  LocalPerceptualMap map({});
  Localiser localiser({}, {});
  std::vector<DriftingPose> poses;
  std::optional<Pose2> drawn_from;
  while (const auto scan = drive.next()) {
    const Localiser::Estimate estimate = localiser.observe(*scan, map);
    const Pose2& robot = estimate.map_from_robot;
    poses.push_back({robot, estimate.drift});
    map.scroll_to(robot.position());
    const Pose2 since = drawn_from ? inverse(*drawn_from) * robot : Pose2{1, 0, 0};
    if (norm(since.position()) < 0.2 && std::abs(since.heading_rad) < 0.1) continue;
    map.update(*scan, robot);
    drawn_from = robot;
  }
  std::vector<Error> errors;
  const auto& visits = drive.truth().trace.visits;
  for (std::size_t k = 1; k < visits.size(); ++k) {
    const auto from = static_cast<std::size_t>((*visits[k - 1].scans)[0]);
    const auto to = static_cast<std::size_t>((*visits[k].scans)[0]);
    const auto& truth = drive.world_from_robot();
    const PoseCovariance covariance = covariance_between(poses[from], poses[to]);
    REQUIRE(is_covariance(covariance));
    const Pose2 estimated = inverse(poses[from].map_from_robot) * poses[to].map_from_robot;
    const Pose2 off = inverse(estimated) * (inverse(truth[from]) * truth[to]);
    errors.push_back({norm(off.position()), std::abs(off.heading_rad),
                      chi_squared({off.x_m, off.y_m, off.heading_rad}, covariance)});
  }
  return errors;
}

}  // namespace

TEST_CASE("displacements are as wrong as their covariances say", "[perception][property]") {
  std::vector<Error> all;
  for (std::uint64_t seed = 101; seed <= 104; ++seed) {
    const std::vector<Error> errors = travels(seed);
    all.insert(all.end(), errors.begin(), errors.end());
  }
  REQUIRE(all.size() == 16);
  double sum = 0;
  for (const Error& error : all) sum += error.chi_squared / 3;
  const double mean = sum / static_cast<double>(all.size());
  CAPTURE(mean);
  // 16 travels: the mean of χ² / 3 is 1 ± 0.2; walls are not as independent as that asks for.
  CHECK(mean > 0.3);
  CHECK(mean < 2);
  CHECK(std::ranges::count_if(
            all, [](const Error& e) { return e.chi_squared < bound_of_95_percent; }) >= 14);
  // The wheels alone: 0.6 m and 5°.
  const auto median = [&](auto part) {
    std::ranges::nth_element(all, all.begin() + 8, {}, part);
    return std::invoke(part, all[8]);
  };
  CHECK(median(&Error::position_m) < 0.1);
  CHECK(median(&Error::heading_rad) < 0.01);
}

}  // namespace asterism
