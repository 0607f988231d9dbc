#include "simulation/drive.hpp"

namespace asterism {

Drive::Drive(const Building& building, const Route& route, const DriveOptions& options,
             std::uint64_t seed)
    : building_(building),
      options_(options),
      engine_(seed),
      walls_(building.walls),
      motion_(move_along(building_, walls_, route, options.motion, engine_)),
      truth_(walk_along(building_.world, route, options.disguised, engine_)),
      people_(building_.world, options.people, RandomEngine(engine_())),
      odometry_(options.odometry, motion_.world_from_robot.front(), RandomEngine(engine_())),
      laser_engine_(engine_()) {
  add_measures();
}

void Drive::add_measures() {
  constexpr double variance = 1e-6;  // of what is exact: a displacement must have one
  const auto& poses = motion_.world_from_robot;
  for (std::size_t k = 0; k < truth_.trace.visits.size(); ++k) {
    Visit& visit = truth_.trace.visits[k];
    const auto [first, last] = motion_.visits[k];
    visit.scans = {static_cast<long long>(first), static_cast<long long>(last)};
    visit.stamps_s = {options_.motion.step_s * static_cast<double>(first),
                      options_.motion.step_s * static_cast<double>(last)};
    if (k == 0) continue;
    const Pose2 moved = inverse(poses[motion_.visits[k - 1][0]]) * poses[first];
    visit.displacement = make_displacement(moved, diagonal(variance, variance));
  }
}

std::optional<Scan> Drive::next() {
  const auto& poses = motion_.world_from_robot;
  if (scan_ == poses.size()) return std::nullopt;
  if (scan_ > 0) odometry_.move(inverse(poses[scan_ - 1]) * poses[scan_]);
  if (travel_ < motion_.departures.size() && motion_.departures[travel_] == scan_) {
    odometry_.begin_travel(motion_.travels_m[travel_]);
    ++travel_;
  }
  people_.walk(options_.motion.step_s, poses[scan_].position());
  const Pose2 world_from_laser = poses[scan_] * options_.laser.layout.robot_from_laser;
  Scan scan{.number = static_cast<long long>(scan_),
            .stamp_s = options_.motion.step_s * static_cast<double>(scan_),
            .odom_from_robot = odometry_.odom_from_robot(),
            .ranges_m = ranges_m(walls_, people_.positions(), world_from_laser, options_.laser,
                                 laser_engine_),
            .laser = options_.laser.layout};
  ++scan_;
  return scan;
}

}  // namespace asterism
