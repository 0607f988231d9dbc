#include "metric/refinement.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/random.hpp"
#include "metric/exponential.hpp"
#include "simulation/drive.hpp"
#include "simulation/ring_building.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

// A drive through a building, and the way as told by someone who drifts.
struct Drifting {
  std::vector<Scan> scans;
  std::vector<Pose2> world_from_robot;
  std::vector<LocalPose> driven;
};

Drifting drifting(unsigned seed, std::size_t travels, double per_m_rad) {
  RandomEngine random(seed);
  const Building building = ring_building(random);
  Route route = ring_route(building.world);
  route.gateways.erase(route.gateways.begin() + static_cast<std::ptrdiff_t>(travels),
                       route.gateways.end());
  Drive drive(building, route, {}, random());
  Drifting result;
  while (auto scan = drive.next()) result.scans.push_back(std::move(*scan));
  result.world_from_robot = drive.world_from_robot();
  Pose2 told;
  for (std::size_t i = 0; i < result.scans.size(); ++i) {
    if (i > 0) {
      const Pose2 step = inverse(result.world_from_robot[i - 1]) * result.world_from_robot[i];
      const double driven_m = norm(step.position());
      told = told * step *
             exponential({0.01 * driven_m * normal(random), 0.01 * driven_m * normal(random),
                          per_m_rad * driven_m + 0.0005 * std::sqrt(driven_m) * normal(random)});
    }
    result.driven.push_back({result.scans[i].stamp_s, told});
  }
  return result;
}

Trajectory as_driven(const Drifting& drive, const Pose2& layout_from_map = {}) {
  Trajectory result;
  for (const LocalPose& pose : drive.driven)
    result.push_back({pose.stamp_s, layout_from_map * pose.map_from_robot});
  return result;
}

// Root mean square, both ways beginning at the same pose.
double error_m(const Drifting& drive, const Trajectory& told) {
  const Pose2 world_from_layout = drive.world_from_robot[0] * inverse(told[0].layout_from_robot);
  double sum = 0;
  for (std::size_t i = 0; i < told.size(); ++i) {
    const Pose2 pose = world_from_layout * told[i].layout_from_robot;
    const double off_m = norm(pose.position() - drive.world_from_robot[i].position());
    sum += off_m * off_m;
  }
  return std::sqrt(sum / static_cast<double>(told.size()));
}

}  // namespace

TEST_CASE("where the robot came by again, its way is set right", "[metric][property]") {
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) {
    const Drifting drive = drifting(seed, 12, 0.00006);
    Refinement refinement(drive.scans, drive.driven);
    const Trajectory start = as_driven(drive);
    const Trajectory refined = refinement(start);
    INFO(error_m(drive, start) << " m, refined " << error_m(drive, refined) << " m");
    REQUIRE(refined.size() == start.size());
    CHECK(error_m(drive, start) > 0.08);
    CHECK(error_m(drive, refined) < 0.08);
    CHECK(error_m(drive, refined) < 0.6 * error_m(drive, start));
    CHECK(refined[0].layout_from_robot == start[0].layout_from_robot);

    // In another frame it is the same way.
    const Pose2 moved{3, -7, 2};
    const Trajectory elsewhere = refinement(as_driven(drive, moved));
    double most_m = 0;
    for (std::size_t i = 0; i < refined.size(); ++i)
      most_m = std::max(most_m, norm((moved * refined[i].layout_from_robot).position() -
                                     elsewhere[i].layout_from_robot.position()));
    CHECK(most_m < 1e-3);
  }
}

TEST_CASE("a way that never comes back stays as it is", "[metric]") {
  const Drifting drive = drifting(3, 3, 0.001);
  const Trajectory start = as_driven(drive);
  CHECK(Refinement(drive.scans, drive.driven)(start) == start);
}

TEST_CASE("a refinement needs a pose a scan", "[metric]") {
  const Drifting drive = drifting(4, 2, 0);
  const std::span<const Scan> scans = drive.scans;
  CHECK_THROWS_AS(Refinement(scans.first(5), drive.driven), std::invalid_argument);
  CHECK_THROWS_AS(Refinement({}, {}), std::invalid_argument);
  Refinement refinement(drive.scans, drive.driven);
  CHECK_THROWS_AS(refinement({}), std::invalid_argument);
}

}  // namespace asterism
