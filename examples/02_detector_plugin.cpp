// A detector of one's own, as a shared library: asterism perceive LOG --detector lib.so loads it.
//
// Its robot helps: wherever corridors meet it halts, turns at least half round, and drives on. So a
// place is where it did that, and a gateway is a direction in which it saw far. Good enough where
// corridors are straight and wheels do not slip; the detector that ships needs neither.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "perception/plugin.hpp"

using namespace asterism;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double still_m = 0.05;              // a robot that halts moves less
constexpr double away_m = 0.5;                // one that has left a place has moved more
constexpr double far_m = 3;                   // a wall so near is no way out
constexpr double straight_rad = radians(30);  // ways out that face each other are one path
constexpr std::size_t sectors = 72;

/// A way out of a place, in the visit's frame.
struct Opening {
  double direction_rad;
  double half_width_rad;
};

double distance(const Pose2& a, const Pose2& b) { return norm(a.position() - b.position()); }

/// Grows clockwise, from half left on; so that ahead comes first, where most robots have a way.
double clockwise_rad(double direction_rad) { return -wrapped(direction_rad + 0.75 * pi); }

/// A halt: what was seen in each direction so far.
class Halt {
 public:
  Halt(const Scan& scan, std::optional<Point2> came_from)
      : odom_from_visit(scan.odom_from_robot), first(scan), last(scan) {
    if (came_from) back_rad = direction(inverse(odom_from_visit) * *came_from);
    look(scan);
  }

  void look(const Scan& scan) {
    last = scan;
    const Pose2 visit_from_robot = inverse(odom_from_visit) * scan.odom_from_robot;
    // Headings wrap, what the robot has turned in all does not.
    heading_rad_ += wrapped(visit_from_robot.heading_rad - heading_rad_);
    least_rad_ = std::min(least_rad_, heading_rad_);
    most_rad_ = std::max(most_rad_, heading_rad_);
    const Pose2 visit_from_laser = visit_from_robot * scan.laser.robot_from_laser;
    for (std::size_t beam = 0; beam < scan.ranges_m.size(); ++beam) {
      const Point2 hit =
          visit_from_laser * (scan.ranges_m[beam] * unit_vector(scan.laser.beam_rad(beam)));
      const double part = (direction(hit) + pi) / (2 * pi);
      double& seen_m = seen_m_[static_cast<std::size_t>(part * sectors) % sectors];
      seen_m = std::max(seen_m, norm(hit));
    }
  }

  bool has_looked_round() const { return most_rad_ - least_rad_ >= pi - 1e-6; }

  /// Runs of sectors in which one sees far, clockwise. None where there is no wall between.
  std::vector<Opening> openings() const {
    const auto is_open = [&](std::size_t sector) { return seen_m_[sector % sectors] >= far_m; };
    std::vector<Opening> result;
    for (std::size_t begin = 1; begin <= sectors; ++begin) {
      if (!is_open(begin) || is_open(begin - 1)) continue;
      std::size_t end = begin;
      while (is_open(end)) ++end;
      if (end - begin < 2) continue;  // half a metre at three: too narrow for a robot
      const double width_rad = static_cast<double>(end - begin) * 2 * pi / sectors;
      const double begin_rad = static_cast<double>(begin) * 2 * pi / sectors - pi;
      result.push_back({wrapped(begin_rad + width_rad / 2), width_rad / 2});
    }
    std::ranges::sort(result, {},
                      [](const Opening& way) { return clockwise_rad(way.direction_rad); });
    return result;
  }

  Pose2 odom_from_visit;
  Scan first;
  Scan last;
  std::optional<double> back_rad = {};  ///< to where the robot came from, if it came from anywhere

 private:
  std::array<double, sectors> seen_m_{};
  double heading_rad_ = 0;
  double least_rad_ = 0;
  double most_rad_ = 0;
};

/// An arm before it has a name.
struct Way {
  double direction_rad;
  std::optional<std::size_t> opening;
  std::size_t path;
};

/// Each opening is an arm. Two that face each other are one path; one alone has its opposite where
/// its path would go on, with no gateway.
std::vector<Way> ways_clockwise(const std::vector<Opening>& openings) {
  std::vector<Way> result;
  std::vector<bool> is_taken(openings.size());
  for (std::size_t i = 0, path = 0; i < openings.size(); ++i) {
    if (is_taken[i]) continue;
    const double ahead_rad = wrapped(openings[i].direction_rad + pi);
    const auto bend_rad = [&](std::size_t j) {
      return std::abs(wrapped(openings[j].direction_rad - ahead_rad));
    };
    std::optional<std::size_t> facing;
    for (std::size_t j = i + 1; j < openings.size(); ++j)
      if (!is_taken[j] && bend_rad(j) < (facing ? bend_rad(*facing) : straight_rad)) facing = j;
    if (facing) is_taken[*facing] = true;
    result.push_back({openings[i].direction_rad, i, path});
    result.push_back({facing ? openings[*facing].direction_rad : ahead_rad, facing, path++});
  }
  std::ranges::stable_sort(result, {},
                           [](const Way& way) { return clockwise_rad(way.direction_rad); });
  return result;
}

/// The arm with a gateway that lies nearest to a direction.
std::size_t arm_towards(const std::vector<Way>& ways, double direction_rad) {
  const auto miss_rad = [&](const Way& way) {
    return way.opening ? std::abs(wrapped(way.direction_rad - direction_rad)) : 2 * pi;
  };
  return static_cast<std::size_t>(std::ranges::min_element(ways, {}, miss_rad) - ways.begin());
}

class HaltDetector : public PlaceDetector {
 public:
  std::string_view name() const noexcept override { return "halts"; }

  std::optional<DetectedVisit> observe(const Scan& scan) override {
    const Pose2& here = scan.odom_from_robot;
    if (halt_) {
      const double moved_m = distance(halt_->odom_from_visit, here);
      if (moved_m < still_m) halt_->look(scan);
      if (moved_m < away_m) return std::nullopt;
      auto visit = visit_of(*halt_, here.position());
      halt_.reset();
      travel_.push_back(here);
      before_ = scan;
      return visit;
    }
    if (before_ && distance(before_->odom_from_robot, here) < still_m) {
      const auto is_away = [&](const Pose2& pose) { return distance(pose, here) >= away_m; };
      const auto from = std::find_if(travel_.rbegin(), travel_.rend(), is_away);
      const bool came = from != travel_.rend();
      halt_.emplace(*before_, came ? std::optional(from->position()) : std::nullopt);
      halt_->look(scan);
    } else {
      travel_.push_back(here);
    }
    before_ = scan;
    return std::nullopt;
  }

  std::optional<DetectedVisit> finish() override {
    if (!halt_) return std::nullopt;
    auto visit = visit_of(*halt_, std::nullopt);
    halt_.reset();
    return visit;
  }

 private:
  std::optional<DetectedVisit> visit_of(const Halt& halt, std::optional<Point2> left_for) {
    const auto openings = halt.openings();
    if (!halt.has_looked_round() || openings.empty()) return std::nullopt;
    const auto ways = ways_clockwise(openings);

    std::vector<Arm> arms;
    std::vector<bool> is_second(ways.size());
    for (const Way& way : ways) {
      const std::string label(1, static_cast<char>('a' + way.path));
      arms.push_back({label, is_second[way.path] ? '-' : '+', way.opening.has_value()});
      is_second[way.path] = true;
    }
    Visit visit{.star = Star(std::move(arms))};
    if (halt.back_rad) visit.entered_by = arm_towards(ways, *halt.back_rad);
    if (left_for)
      visit.left_by = arm_towards(ways, direction(inverse(halt.odom_from_visit) * *left_for));
    visit.scans = {halt.first.number, halt.last.number};
    visit.stamps_s = {halt.first.stamp_s, halt.last.stamp_s};
    for (std::size_t arm = 0; arm < ways.size(); ++arm) {
      if (!ways[arm].opening) continue;
      const auto [direction_rad, half_width_rad] = openings[*ways[arm].opening];
      const Point2 at = far_m * std::cos(half_width_rad) * unit_vector(direction_rad);
      visit.gateways.push_back({visit.star.name(arm), at.x_m, at.y_m, direction_rad,
                                2 * far_m * std::sin(half_width_rad)});
    }
    if (odom_from_left_) {
      const Pose2 moved = inverse(*odom_from_left_) * halt.odom_from_visit;
      const double slip_m2 = std::pow(0.05 * norm(moved.position()), 2);  // five per cent
      const double slip_rad2 = std::pow(radians(5), 2);
      visit.displacement = make_displacement(moved, diagonal(slip_m2, slip_rad2));
    }
    odom_from_left_ = halt.odom_from_visit;
    travel_.clear();
    return DetectedVisit{std::move(visit)};
  }

  std::optional<Halt> halt_;
  std::optional<Scan> before_;  // while travelling
  std::vector<Pose2> travel_;   // since the last visit, in the frame of the odometry
  std::optional<Pose2> odom_from_left_;
};

std::unique_ptr<PlaceDetector> halt_detector() { return std::make_unique<HaltDetector>(); }

}  // namespace

// What the library is asked for. The rest is filled in by default: version, compiler, layout.
const DetectorPlugin asterism_detector_plugin{.create = halt_detector};
