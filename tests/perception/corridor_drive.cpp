#include "tests/perception/corridor_drive.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asterism {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::size_t beams = 181;

bool is_free(Point2 at) {
  const auto within = [at](double left_m, double right_m, double low_m, double high_m) {
    return at.x_m > left_m && at.x_m < right_m && at.y_m > low_m && at.y_m < high_m;
  };
  return within(-6, 18, -1, 1) || within(-1, 1, -6, 6) || within(11, 13, -6, 1);
}

class Drive {
 public:
  explicit Drive(Pose2 start) : world_from_robot_(start) { look(); }

  void go(double distance_m) {
    for (int step = 0; step < std::lround(distance_m / step_m); ++step) move({step_m, 0, 0});
  }
  void turn(double angle_rad) {
    const long steps = std::lround(std::abs(angle_rad) / turn_rad);
    for (long step = 0; step < steps; ++step) move({0, 0, std::copysign(turn_rad, angle_rad)});
  }

  std::vector<Scan> scans;

 private:
  static constexpr double step_m = 0.25;
  static constexpr double turn_rad = pi / 12;
  static constexpr LaserLayout laser{-pi / 2, pi / (beams - 1), 8, {0.1, 0, 0}};

  void move(const Pose2& before_from_after) {
    world_from_robot_ = world_from_robot_ * before_from_after;
    look();
  }

  void look() {
    const auto number = static_cast<long long>(scans.size());
    Scan scan{number, 0.5 * static_cast<double>(number), world_from_robot_, {}, laser};
    const Pose2 world_from_laser = world_from_robot_ * laser.robot_from_laser;
    for (std::size_t beam = 0; beam < beams; ++beam) {
      double range_m = 0;
      while (range_m < laser.max_range_m &&
             is_free(world_from_laser * (range_m * unit_vector(laser.beam_rad(beam)))))
        range_m += 0.05;
      scan.ranges_m.push_back(std::min(range_m, laser.max_range_m));
    }
    scans.push_back(std::move(scan));
  }

  Pose2 world_from_robot_;
};

}  // namespace

std::vector<Scan> corridor_drive() {
  Drive drive({-4, 0, 0});
  drive.go(4);
  drive.turn(2 * pi);
  drive.go(12);
  drive.turn(3 * pi);
  drive.go(12);
  drive.turn(2 * pi - pi / 2);
  drive.go(3);
  return drive.scans;
}

}  // namespace asterism
