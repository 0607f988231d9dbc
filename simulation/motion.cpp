#include "simulation/motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asterism {
namespace {

constexpr double spacing_m = 0.05;        ///< between two points of a line to drive
constexpr double max_off_middle_m = 0.2;  ///< of a stop, ahead and aside

/// How far to the left of a corridor's middle a robot may be.
struct Lane {
  double right_m;
  double left_m;
};

/// The lane at every point of a line: what is clear on both sides, there and a little way round.
std::vector<Lane> lanes(Point2 from, Point2 along, std::size_t count, const RayCaster& walls,
                        double side_m) {
  constexpr double far_m = 5;
  constexpr std::size_t window = 16;  // a robot is not as thin as a beam, nor does it jump aside
  const Point2 left = left_of(along);
  std::vector<Lane> here;
  for (std::size_t i = 0; i < count; ++i) {
    const Point2 at = from + spacing_m * static_cast<double>(i) * along;
    const auto clear_m = [&](Point2 way) {
      const auto hit = walls.cast(at, way, far_m);
      return (hit ? hit->distance_m : far_m) - side_m;
    };
    here.push_back({-clear_m(-1.0 * left), clear_m(left)});
  }
  std::vector<Lane> result;
  for (std::size_t i = 0; i < count; ++i) {
    Lane lane = here[i];
    for (std::size_t j = i < window ? 0 : i - window; j < std::min(count, i + window + 1); ++j) {
      lane.right_m = std::max(lane.right_m, here[j].right_m);
      lane.left_m = std::min(lane.left_m, here[j].left_m);
    }
    if (lane.right_m > lane.left_m) lane.right_m = lane.left_m = (lane.right_m + lane.left_m) / 2;
    result.push_back(lane);
  }
  return result;
}

/// Each number's mean with its neighbours, beyond the ends taken for equal to the ends.
std::vector<double> smoothed(const std::vector<double>& numbers) {
  constexpr std::ptrdiff_t window = 10;
  const auto last = static_cast<std::ptrdiff_t>(numbers.size()) - 1;
  std::vector<double> result;
  for (std::ptrdiff_t i = 0; i <= last; ++i) {
    double sum = 0;
    for (std::ptrdiff_t j = i - window; j <= i + window; ++j)
      sum += numbers[static_cast<std::size_t>(std::clamp(j, std::ptrdiff_t{0}, last))];
    result.push_back(sum / (2 * window + 1));
  }
  return result;
}

class Mover {
 public:
  Mover(const RayCaster& walls, const MotionOptions& options, RandomEngine& engine)
      : walls_(walls), options_(options), engine_(engine) {}

  void start(const Pose2& pose) { motion_.world_from_robot.push_back(pose); }

  void look_round() {
    stand();
    turn(chance(0.5, engine_) ? options_.look_round_rad : -options_.look_round_rad);
    stand();
  }

  void turn_to(double heading_rad) { turn(wrapped(heading_rad - pose().heading_rad)); }

  /// From here to `to`; the corridor's middle line runs from place to place.
  void drive(Point2 from_place, Point2 to_place, Point2 to) {
    const std::vector<Point2> line = line_between(from_place, to_place, to);
    turn_to(direction(line[look_ahead] - line.front()));
    double length_m = 0;
    for (std::size_t i = 1; i < line.size(); ++i) length_m += norm(line[i] - line[i - 1]);
    motion_.departures.push_back(motion_.world_from_robot.size() - 1);
    motion_.travels_m.push_back(length_m);
    follow(line, length_m);
  }

  Motion&& take() { return std::move(motion_); }
  const Pose2& pose() const { return motion_.world_from_robot.back(); }
  std::size_t now() const { return motion_.world_from_robot.size() - 1; }

 private:
  static constexpr std::size_t look_ahead = 4;  ///< points of the line that give its direction

  void stand() {
    const double steps = between(1, options_.max_stand_s, engine_) / options_.step_s;
    for (int i = 0; i < steps; ++i) motion_.world_from_robot.push_back(Pose2(pose()));
  }

  void turn(double angle_rad) {
    const double rate = between(0.8, 1.2, engine_) * options_.turn_rad_per_s * options_.step_s;
    const double steps = std::ceil(std::abs(angle_rad) / rate);
    const Pose2 before = pose();
    for (double i = 1; i <= steps; ++i)
      motion_.world_from_robot.push_back(
          {before.x_m, before.y_m, wrapped(before.heading_rad + angle_rad * i / steps)});
  }

  std::vector<Point2> line_between(Point2 from_place, Point2 to_place, Point2 to) {
    const Point2 along = unit_towards(from_place, to_place);
    const Point2 left = left_of(along);
    const Point2 from = pose().position();
    const double length_m = dot(to - from, along);
    const auto count = static_cast<std::size_t>(length_m / spacing_m) + 1;
    const double begin_m = dot(from - from_place, along);
    const std::vector<Lane> lane =
        lanes(from_place + begin_m * along, along, count, walls_, options_.side_m);

    const double sway_m = between(0, 0.2, engine_);
    const double wave_m = between(5, 12, engine_);
    const double phase_rad = between(0, 2 * std::numbers::pi, engine_);
    const double aside_m = between(-0.15, 0.15, engine_);
    constexpr double straight_m = 0.6;  // near a stop, beyond what smoothing reaches
    std::vector<double> offsets_m;
    for (std::size_t i = 0; i < count; ++i) {
      const double at_m = spacing_m * static_cast<double>(i);
      const double swaying_m =
          aside_m + sway_m * std::sin(phase_rad + 2 * std::numbers::pi * at_m / wave_m);
      offsets_m.push_back(std::clamp(swaying_m, lane[i].right_m, lane[i].left_m));
      if (at_m < straight_m) offsets_m.back() = dot(from - from_place, left);
      if (at_m > length_m - straight_m) offsets_m.back() = dot(to - from_place, left);
    }
    offsets_m = smoothed(offsets_m);
    std::vector<Point2> line;
    for (std::size_t i = 0; i < count; ++i)
      line.push_back(from_place + (begin_m + spacing_m * static_cast<double>(i)) * along +
                     offsets_m[i] * left);
    return line;
  }

  void follow(const std::vector<Point2>& line, double length_m) {
    double speed = 0;
    double gone_m = 0;  // along the line
    double line_m = 0;  // to line[next - 1]
    std::size_t next = 1;
    while (true) {
      const double to_go_m = length_m - gone_m;
      speed = std::min({options_.speed_m_per_s,
                        speed + options_.acceleration_m_per_s2 * options_.step_s,
                        std::sqrt(2 * options_.acceleration_m_per_s2 * to_go_m)});
      gone_m += speed * options_.step_s;
      if (gone_m >= length_m - 0.01) return;
      while (line_m + norm(line[next] - line[next - 1]) < gone_m) {
        line_m += norm(line[next] - line[next - 1]);
        ++next;
      }
      const Point2 way = line[next] - line[next - 1];
      const Point2 at = line[next - 1] + ((gone_m - line_m) / norm(way)) * way;
      const Point2 ahead = line[std::min(next + look_ahead, line.size() - 1)] -
                           line[next > look_ahead ? next - look_ahead : 0];
      motion_.world_from_robot.push_back({at.x_m, at.y_m, direction(ahead)});
    }
  }

  const RayCaster& walls_;
  const MotionOptions& options_;
  RandomEngine& engine_;
  Motion motion_;
};

}  // namespace

Motion move_along(const Building& building, const RayCaster& walls, const Route& route,
                  const MotionOptions& options, RandomEngine& engine) {
  const World& world = building.world;
  const auto position = [&](PlaceId place) { return world.places.at(place.index()).position; };
  // In the frame of the corridor come by, so that a turned building has the turned drive.
  const auto stop_at = [&](PlaceId place, Point2 along) {
    const double ahead_m = between(-max_off_middle_m, max_off_middle_m, engine);
    const double left_m = between(-max_off_middle_m, max_off_middle_m, engine);
    return position(place) + ahead_m * along + left_m * left_of(along);
  };
  std::vector<PlaceId> places{route.start};
  for (const PlaceArm& gateway : route.gateways) places.push_back(world.segments.at(gateway).place);

  Mover mover(walls, options, engine);
  const double heading_rad =
      route.gateways.empty() ? 0
                             : arm_headings_rad(world, route.start).at(route.gateways.front().arm);
  const Point2 first = stop_at(route.start, unit_vector(heading_rad));
  mover.start({first.x_m, first.y_m, heading_rad});
  std::vector<std::size_t> stops{mover.now()};
  mover.look_round();
  for (std::size_t k = 1; k < places.size(); ++k) {
    const Point2 from = position(places[k - 1]);
    const Point2 to = position(places[k]);
    mover.drive(from, to, stop_at(places[k], unit_towards(from, to)));
    stops.push_back(mover.now());
    mover.look_round();
  }
  Motion motion = mover.take();
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto is_there = [&](std::size_t scan) {
      return norm(motion.world_from_robot[scan].position() - position(places[k])) <=
             building.place_radius_m[places[k].index()];
    };
    std::size_t begin = stops[k];
    std::size_t end = stops[k];
    while (begin > 0 && is_there(begin - 1)) --begin;
    while (end + 1 < motion.world_from_robot.size() && is_there(end + 1)) ++end;
    motion.visits.push_back({begin, end});
  }
  return motion;
}

}  // namespace asterism
