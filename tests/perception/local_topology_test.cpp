#include "perception/local_topology.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/ideal_world.hpp"

namespace asterism {
namespace {

constexpr double pi = std::numbers::pi;

// Shares that the laws ask for.
constexpr double quarter_turns = 0.98;
constexpr double every_5_degrees = 0.95;
constexpr double other_resolutions = 0.90;

bool same(const Star& a, const Star& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (a.view(0) == b.view(i)) return true;
  }
  return false;
}

Star mirror_image(const Star& star) {
  std::vector<Arm> arms;
  for (std::size_t i = star.size(); i-- > 0;) arms.push_back(star.arm(i));
  return Star(std::move(arms));
}

std::string text(const std::optional<LocalStar>& star) { return star ? star->star.text() : "none"; }

std::optional<LocalStar> star_of(const Grid& grid, Point2 robot) {
  return local_topology(grid, robot).star;
}

// How many cases agree, and what the others were.
struct Tally {
  std::size_t all = 0;
  std::size_t good = 0;
  std::string bad = {};

  void count(bool is_good, const std::string& what) {
    ++all;
    good += is_good;
    if (!is_good) bad += what + "\n";
  }
  double share() const { return static_cast<double>(good) / static_cast<double>(all); }
  std::string text(const std::string& name) const {
    return name + ": " + std::to_string(good) + " of " + std::to_string(all) + "\n" + bad;
  }
};

struct Case {
  IdealWorld world;
  double width_m;
  Point2 robot;

  std::string text() const {
    return world.name + " " + std::to_string(width_m) + " m wide, robot at " +
           std::to_string(robot.x_m) + ", " + std::to_string(robot.y_m);
  }
};

// Each kind of place in each of several widths, the robot anywhere near its middle.
std::vector<Case> cases(int widths, std::uint64_t seed) {
  RandomEngine random(seed);
  std::vector<Case> all;
  for (int i = 0; i < widths; ++i) {
    const double width_m = between(1.6, 3.5, random);
    for (const IdealWorld& world : ideal_worlds(width_m)) {
      const double far_m = 0.3 * width_m;
      all.push_back(
          {world, width_m, {between(-far_m, far_m, random), between(-far_m, far_m, random)}});
    }
  }
  return all;
}

}  // namespace

//      |          |         |       \   /               |
//      +--     ---+---   ---+---      |      [----    --( )--    -------
//                           |         |                 |
TEST_CASE("ideal worlds have their true stars", "[perception][property]") {
  Tally tally;
  for (const Case& each : cases(20, 1)) {
    const auto star = star_of(drawn(each.world), each.robot);
    tally.count(star && same(star->star, Star::parse(each.world.star)) &&
                    is_on_path(*star) == (each.world.name == "corridor"),
                each.text() + ": found " + text(star) + "; expected " + each.world.star);
  }
  INFO(tally.text("true stars"));
  CHECK(tally.share() >= quarter_turns);
}

TEST_CASE("gateways of ideal worlds face along their corridors", "[perception]") {
  for (const Case& each : cases(3, 2)) {
    const LocalTopology seen = local_topology(drawn(each.world), each.robot);
    REQUIRE(seen.star);
    for (const Gateway& gateway : seen.neighbourhood->gateways) {
      double off_rad = pi;
      for (const IdealCorridor& corridor : each.world.corridors) {
        off_rad = std::min(off_rad, std::abs(wrapped(gateway.outward_rad - corridor.heading_rad)));
      }
      CAPTURE(each.text());
      CHECK(off_rad < 0.1);  // 6°: an arm's ray has crossed its corridor after ten widths
      CHECK(gateway.width_m <= each.width_m + 0.1);
      CHECK(gateway.width_m >= each.width_m - 0.4);
    }
  }
}

TEST_CASE("a place turned or mirrored has the same star, turned or mirrored",
          "[perception][property]") {
  Tally quarters;
  Tally mirrors;
  Tally degrees;
  for (const Case& each : cases(5, 3)) {
    const auto before = star_of(drawn(each.world), each.robot);
    REQUIRE(before);
    const auto same_turned = [&](int degree, bool mirror) {
      const double angle_rad = degree * pi / 180;
      const Point2 robot = turned(each.robot, angle_rad);
      const IdealWorld world = turned(each.world, angle_rad);
      const auto after = mirror ? star_of(drawn(mirrored(world)), {robot.x_m, -robot.y_m})
                                : star_of(drawn(world), robot);
      const bool good =
          after && same(after->star, mirror ? mirror_image(before->star) : before->star);
      return std::pair{good, each.text() + " turned by " + std::to_string(degree) + ": found " +
                                 text(after) + "; expected " + text(before)};
    };
    const auto count = [](Tally& tally, const std::pair<bool, std::string>& result) {
      tally.count(result.first, result.second);
    };
    for (const int degree : {90, 180, 270}) count(quarters, same_turned(degree, false));
    for (const int degree : {0, 90, 180, 270}) count(mirrors, same_turned(degree, true));
    for (int degree = 5; degree < 90; degree += 5) count(degrees, same_turned(degree, false));
  }
  INFO(quarters.text("quarter turns"));
  INFO(mirrors.text("mirror images"));
  INFO(degrees.text("every 5 degrees"));
  CHECK(quarters.share() >= quarter_turns);
  CHECK(mirrors.share() >= quarter_turns);
  CHECK(degrees.share() >= every_5_degrees);
}

TEST_CASE("a finer or a coarser grid gives the same star", "[perception][property]") {
  const auto [cells, resolution_m] = GENERATE(table<int, double>({{600, 0.05}, {200, 0.15}}));
  Tally tally;
  for (const Case& each : cases(6, 4)) {
    const auto usual = star_of(drawn(each.world), each.robot);
    REQUIRE(usual);
    const auto star = star_of(drawn(each.world, cells, resolution_m), each.robot);
    tally.count(star && same(star->star, usual->star),
                each.text() + ": found " + text(star) + "; expected " + text(usual));
  }
  INFO(tally.text("cells of " + std::to_string(resolution_m) + " m"));
  CHECK(tally.share() >= other_resolutions);
}

}  // namespace asterism
