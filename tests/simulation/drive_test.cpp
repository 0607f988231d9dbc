#include "simulation/drive.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/office_building.hpp"
#include "simulation/ring_building.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

constexpr double rounding = 1e-9;  ///< metres or radians

std::vector<Scan> scans_of(Drive& drive) {
  std::vector<Scan> scans;
  while (auto scan = drive.next()) scans.push_back(std::move(*scan));
  return scans;
}

double distance_m(Point2 point, const Wall& wall) {
  const Point2 side = wall.to - wall.from;
  const double share = std::clamp(dot(point - wall.from, side) / dot(side, side), 0.0, 1.0);
  return norm(point - wall.from - share * side);
}

/// Within a share of what is expected.
bool is_near(double value, double expected, double share = 1e-6) {
  return std::abs(value - expected) <= share * std::abs(expected);
}

double root_mean_square(const std::vector<double>& numbers) {
  double sum = 0;
  for (const double number : numbers) sum += number * number;
  return std::sqrt(sum / static_cast<double>(numbers.size()));
}

double apart_rad(const Pose2& a, const Pose2& b) {
  return std::abs(wrapped(a.heading_rad - b.heading_rad));
}

}  // namespace

TEST_CASE("a drive keeps clear of walls and things, and does not jump", "[simulation][property]") {
  const auto seed = GENERATE(range(0U, 30U));
  RandomEngine engine(seed);
  const Building building = seed % 10 == 0 ? ring_building(engine) : office_building({}, engine);
  const Route route = random_route(building.world, {.travels = 10}, engine);
  const DriveOptions options;
  const Drive drive(building, route, options, seed);
  const auto& poses = drive.world_from_robot();
  for (std::size_t i = 0; i < poses.size(); i += 2) {
    double clear_m = 100;
    for (const Wall& wall : building.walls)
      clear_m = std::min(clear_m, distance_m(poses[i].position(), wall));
    REQUIRE(clear_m > 0.25);  // what a small robot needs
  }
  for (std::size_t i = 1; i < poses.size(); ++i) {
    REQUIRE(norm(poses[i].position() - poses[i - 1].position()) <
            1.2 * options.motion.speed_m_per_s * options.motion.step_s);
    REQUIRE(apart_rad(poses[i], poses[i - 1]) <
            1.3 * options.motion.turn_rad_per_s * options.motion.step_s);
  }
}

TEST_CASE("the true trace is where the robot truly was", "[simulation][property]") {
  const auto seed = GENERATE(range(0U, 40U));
  RandomEngine engine(seed);
  const Building building = seed % 10 == 0 ? ring_building(engine) : office_building({}, engine);
  const Route route = random_route(building.world, {.travels = 12}, engine);
  const Drive drive(building, route, {}, seed);
  const auto& poses = drive.world_from_robot();
  const auto& [trace, truth] = drive.truth();
  CHECK_NOTHROW(require_valid(trace));
  REQUIRE(trace.visits.size() == 13);
  CHECK(is_consistent(trace, truth, {.planar = true}));

  std::size_t scan = 0;
  for (const Visit& visit : trace.visits) {
    const auto place = std::stoul(visit.true_place.value());
    const Point2 middle = building.world.places.at(place).position;
    const auto first = static_cast<std::size_t>(visit.scans.value()[0]);
    const auto last = static_cast<std::size_t>(visit.scans.value()[1]);
    REQUIRE(scan <= first);
    REQUIRE(first < last);
    for (; scan < first; ++scan)  // on the way from the place before, at none
      for (std::size_t other = 0; other < building.world.places.size(); ++other)
        REQUIRE(norm(poses[scan].position() - building.world.places[other].position) >
                building.place_radius_m[other] - rounding);
    double seen_rad = 0;
    double nearest_m = 100;
    for (; scan <= last; ++scan) {
      nearest_m = std::min(nearest_m, norm(poses[scan].position() - middle));
      if (scan > first) seen_rad += apart_rad(poses[scan], poses[scan - 1]);
      REQUIRE(norm(poses[scan].position() - middle) <= building.place_radius_m[place] + rounding);
    }
    CHECK(nearest_m < 0.35);
    CHECK(seen_rad > 2 * std::numbers::pi);
    CHECK(last - first > 50);  // ten seconds
  }
  CHECK(scan == poses.size());

  Pose2 frame = poses[static_cast<std::size_t>(trace.visits.front().scans.value()[0])];
  for (std::size_t k = 1; k < trace.visits.size(); ++k) {
    const Displacement& moved = trace.visits[k].displacement.value();
    frame = frame * moved.left_from_reached();
    const Pose2& there = poses[static_cast<std::size_t>(trace.visits[k].scans.value()[0])];
    CHECK(norm(there.position() - frame.position()) < 1e-6);
    CHECK(apart_rad(there, frame) < 1e-6);
  }
}

TEST_CASE("a robot enters and leaves by the arms of the true trace", "[simulation][property]") {
  const auto seed = GENERATE(range(0U, 20U));
  RandomEngine engine(seed);
  const Building building = office_building({}, engine);
  const Route route = random_route(building.world, {.travels = 10}, engine);
  const Drive drive(building, route, {.disguised = false}, seed);
  for (const Visit& visit : drive.truth().trace.visits) {
    const PlaceId place(std::stoul(visit.true_place.value()));
    const Point2 middle = building.world.places[place.index()].position;
    const auto headings_rad = arm_headings_rad(building.world, place);
    const auto leads_to = [&](std::size_t arm, long long scan) {
      const Pose2& pose = drive.world_from_robot()[static_cast<std::size_t>(scan)];
      return std::abs(wrapped(direction(pose.position() - middle) - headings_rad[arm])) < 0.35;
    };
    if (visit.entered_by) CHECK(leads_to(*visit.entered_by, visit.scans.value()[0]));
    if (visit.left_by) CHECK(leads_to(*visit.left_by, visit.scans.value()[1]));
  }
}

TEST_CASE("the laser tells the walls, with noise, and some beams never return",
          "[simulation][laser]") {
  RandomEngine engine(5);
  const Building building = ring_building(engine);
  const RayCaster walls(building.walls);
  Drive drive(building, ring_route(building.world), {.people = 0}, 5);
  const auto poses = drive.world_from_robot();
  const LaserOptions laser;
  std::vector<double> errors_m;
  std::size_t missing = 0;
  for (const Scan& scan : scans_of(drive)) {
    REQUIRE(scan.ranges_m.size() == laser.beams);
    for (std::size_t beam = 0; beam < laser.beams; beam += 7) {
      const Pose2& pose = poses[static_cast<std::size_t>(scan.number)];
      const Point2 way = unit_vector(pose.heading_rad + scan.laser.beam_rad(beam));
      const auto hit = walls.cast(pose.position(), way, 80);
      if (hit->is_glass) continue;
      const double range_m = scan.ranges_m[beam];
      if (range_m == scan.laser.max_range_m)
        ++missing;
      else
        errors_m.push_back(range_m - hit->distance_m);
      CHECK(std::abs(range_m * 100 - std::round(range_m * 100)) < 1e-6);
    }
  }
  REQUIRE(errors_m.size() > 50'000);
  CHECK(is_near(root_mean_square(errors_m), laser.noise_m, 0.05));
  CHECK(is_near(static_cast<double>(missing) / static_cast<double>(errors_m.size()), laser.missing,
                0.15));
}

TEST_CASE("glass gives few beams back", "[simulation][laser]") {
  FloorPlan plan;
  plan.rooms = {rectangle({-5, 0}, {5, 0}, 10)};
  plan.panes = {{{2, -5}, {2, 5}}};
  const RayCaster walls(walls_of(plan));
  RandomEngine engine(1);
  LaserOptions laser;
  laser.layout.first_beam_rad = -0.5;
  laser.layout.beam_step_rad = 1e-4;
  laser.beams = 10'000;
  const auto seen_m = ranges_m(walls, {}, {}, laser, engine);
  const auto missing = std::count(seen_m.begin(), seen_m.end(), laser.layout.max_range_m);
  CHECK(is_near(static_cast<double>(missing), 9000, 0.02));
}

TEST_CASE("a person hides the wall behind", "[simulation][laser]") {
  FloorPlan plan;
  plan.rooms = {rectangle({-5, 0}, {5, 0}, 10)};
  const RayCaster walls(walls_of(plan));
  RandomEngine engine(1);
  LaserOptions laser{.noise_m = 0, .missing = 0, .quantum_m = 0};
  const std::vector<Person> people{{{3, 0}, 0.25}};
  const auto seen_m = ranges_m(walls, people, {}, laser, engine);
  CHECK(is_near(seen_m[90], 2.75));
  CHECK(is_near(seen_m[80], 5 / std::cos(10 * std::numbers::pi / 180)));
  CHECK(is_near(seen_m[0], 5));
}

TEST_CASE("nobody walks into the robot, and someone is near it", "[simulation][property]") {
  const auto seed = GENERATE(range(0U, 10U));
  RandomEngine engine(seed);
  const Building building = office_building({}, engine);
  const Drive drive(building, random_route(building.world, {.travels = 8}, engine), {}, seed);
  People people(building.world, 2, RandomEngine(seed));
  std::size_t near = 0;
  for (const Pose2& pose : drive.world_from_robot()) {
    people.walk(0.2, pose.position());
    REQUIRE(people.positions().size() == 2);
    for (const Person& person : people.positions()) {
      const double away_m = norm(person.position - pose.position());
      REQUIRE(away_m > 0.6);
      if (away_m < 10) ++near;
    }
  }
  CHECK(near > drive.world_from_robot().size() / 2);
}

TEST_CASE("odometry is off by what it says: by 5 % of the way and 5° a travel",
          "[simulation][property]") {
  std::vector<double> distance_shares;
  std::vector<double> travel_turns_rad;
  std::vector<double> visit_turns_rad;
  const DriveOptions options{.laser = {.beams = 1}, .people = 0};
  for (unsigned seed = 0; seed < 60; ++seed) {
    RandomEngine engine(seed);
    const Building building = office_building({}, engine);
    Drive drive(building, random_route(building.world, {.travels = 12}, engine), options, seed);
    const auto poses = drive.world_from_robot();
    const std::vector<Scan> scans = scans_of(drive);
    CHECK(scans.front().odom_from_robot == poses.front());
    const auto& visits = drive.truth().trace.visits;
    for (std::size_t k = 0; k < visits.size(); ++k) {
      const auto between_scans = [&](long long from, long long to) {
        const auto [i, j] = std::pair(static_cast<std::size_t>(from), static_cast<std::size_t>(to));
        return std::pair(inverse(poses[i]) * poses[j],
                         inverse(scans[i].odom_from_robot) * scans[j].odom_from_robot);
      };
      const auto [first, last] = visits[k].scans.value();
      const auto [there, told_there] = between_scans(first, last);
      visit_turns_rad.push_back(apart_rad(there, told_there));
      if (k == 0) continue;
      const auto [moved, told] = between_scans(visits[k - 1].scans.value()[1], first);
      distance_shares.push_back(norm(told.position()) / norm(moved.position()) - 1);
      // Drift grows with the way: what is driven between the two circles is part of a travel.
      const double share = norm(moved.position()) / (norm(moved.position()) + 5);
      travel_turns_rad.push_back(apart_rad(moved, told) / share);
    }
  }
  REQUIRE(distance_shares.size() == 720);
  CHECK(is_near(root_mean_square(distance_shares), 0.05, 0.12));
  CHECK(is_near(root_mean_square(travel_turns_rad) * 180 / std::numbers::pi, 5, 0.15));
  CHECK(root_mean_square(visit_turns_rad) * 180 / std::numbers::pi < 4);
}

TEST_CASE("the same seed drives and senses the same, another not", "[simulation]") {
  RandomEngine engine(9);
  const Building building = office_building({}, engine);
  const Route route = random_route(building.world, {.travels = 4}, engine);
  Drive one(building, route, {}, 7);
  Drive same(building, route, {}, 7);
  Drive other(building, route, {}, 8);
  Drive alone(building, route, {.people = 0}, 7);
  CHECK(one.world_from_robot() == same.world_from_robot());
  CHECK(one.world_from_robot() == alone.world_from_robot());
  CHECK(one.world_from_robot() != other.world_from_robot());
  const std::vector<Scan> scans = scans_of(one);
  const std::vector<Scan> same_scans = scans_of(same);
  const std::vector<Scan> alone_scans = scans_of(alone);
  REQUIRE(scans.size() == same_scans.size());
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    CHECK(scans[i].ranges_m == same_scans[i].ranges_m);
    CHECK(scans[i].odom_from_robot == same_scans[i].odom_from_robot);
    CHECK(scans[i].odom_from_robot == alone_scans[i].odom_from_robot);
    if (scans[i].ranges_m != alone_scans[i].ranges_m) ++hidden;
  }
  CHECK(hidden > 0);
}

TEST_CASE("a turned building is driven alike", "[simulation][property]") {
  const auto seed = GENERATE(range(0U, 10U));
  RandomEngine engine(seed);
  const Building building = office_building({}, engine);
  const Pose2 there_from_here{5, -3, 0.3 + seed};
  const Route route = random_route(building.world, {.travels = 6}, engine);
  const Drive drive(building, route, {}, seed);
  const Drive turned(moved(building, there_from_here), route, {}, seed);
  REQUIRE(drive.world_from_robot().size() == turned.world_from_robot().size());
  for (std::size_t i = 0; i < drive.world_from_robot().size(); ++i) {
    const Pose2 expected = there_from_here * drive.world_from_robot()[i];
    REQUIRE(norm(expected.position() - turned.world_from_robot()[i].position()) < 1e-3);
    REQUIRE(apart_rad(expected, turned.world_from_robot()[i]) < 1e-3);
  }
}
