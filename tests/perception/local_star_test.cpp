#include "perception/local_star.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

constexpr double pi = std::numbers::pi;

// A gateway two metres from the place's centre, in this direction.
Gateway at(double degrees, double width_m = 2) {
  const double outward_rad = wrapped(radians(degrees));
  return {2 * unit_vector(outward_rad), outward_rad, width_m};
}

std::vector<Gateway> all_at(const std::vector<double>& degrees) {
  std::vector<Gateway> gateways;
  for (const double degree : degrees) gateways.push_back(at(degree));
  return gateways;
}

bool same(const Star& a, const Star& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (a.view(0) == b.view(i)) return true;
  }
  return false;
}

std::vector<std::string> arms_out(const LocalStar& local) {
  std::vector<std::string> names;
  for (const std::size_t arm : local.arm_of_gateway) names.push_back(local.star.name(arm));
  return names;
}

}  // namespace

// Clockwise from +x: 0°, then -90°, then 180°, then 90°; all ten degrees past: seen from amid
// the gateways, the first arm may else be the last.
TEST_CASE("arms run clockwise from +x, labels in order of first arms", "[perception]") {
  using Degrees = std::vector<double>;
  const auto [degrees, star] = GENERATE(table<Degrees, std::string>({
      {{0}, "a+1 a-0"},
      {{180}, "a+0 a-1"},
      {{0, 180}, "a+1 a-1"},
      {{0, 90}, "a+1 b+0 a-0 b-1"},
      {{20, 90, 200}, "a+0 b+1 a-1 b-1"},
      {{0, 90, 180}, "a+1 b+0 a-1 b-1"},
      {{0, -90, 180}, "a+1 b+1 a-1 b-0"},
      {{0, 90, 180, 270}, "a+1 b+1 a-1 b-1"},
      {{0, 120, 240}, "a+1 b+0 c+1 a-0 b-1 c-0"},
      {{0, 60, 120, 180, 240, 300}, "a+1 b+1 c+1 a-1 b-1 c-1"},
  }));
  CAPTURE(degrees);
  std::vector<double> past = degrees;
  for (double& degree : past) degree -= 10;
  CHECK(local_star(all_at(past)).star.text() == star);
}

TEST_CASE("each gateway knows the arm that leads out of it", "[perception]") {
  const LocalStar local = local_star(all_at({170, -10, -100}));
  CHECK(local.star.text() == "a+1 b+1 a-1 b-0");
  CHECK(arms_out(local) == std::vector<std::string>{"a-", "a+", "b+"});
  for (const std::size_t arm : local.arm_of_gateway) CHECK(local.star.has_gateway(arm));
}

//       g1 |  |            The inward rays of an L's gateways cross the other gateway's side
//          |  |            of the place, not the gateway: each path ends here, and out of the
//     -----+  |            far side come two rays, in the order of the gateways.
//     g0      |
//     --------+
TEST_CASE("an L's two rays keep their order", "[perception]") {
  // Wherever the gateways stand, the rays go out at the gateways' headings turned round.
  RandomEngine random(1);
  for (int corner = 0; corner < 300; ++corner) {
    const double heading = between(0, 360, random);
    const double bend = between(50, 130, random);
    std::vector<Gateway> gateways{at(heading), at(heading + bend)};
    for (Gateway& gateway : gateways) {
      gateway.middle =
          gateway.middle + Point2{between(-0.3, 0.3, random), between(-0.3, 0.3, random)};
    }
    const LocalStar local = local_star(gateways);
    CAPTURE(corner, heading, bend, local.star.text());
    REQUIRE(local.star.size() == 4);
    // Clockwise: the second gateway, the first, the second's end, the first's end.
    const std::size_t second = local.arm_of_gateway[1];
    REQUIRE(local.star.clockwise(second, 1) == local.arm_of_gateway[0]);
    REQUIRE(local.star.view(second) == Star::parse("a+1 b+1 a-0 b-0").view(0));
    REQUIRE_FALSE(is_on_path(local));
  }
}

//          g1
//   g0 ---------- g2      g0 and g2 face each other best; g1, just off g2, is left over
//
TEST_CASE("the best pairs come first", "[perception]") {
  const Gateway west = at(180);
  const Gateway east = at(2);
  Gateway off = at(25);
  off.middle = {2, 0.4};
  for (const auto& gateways :
       {std::vector{west, east, off}, std::vector{west, off, east}, std::vector{off, east, west}}) {
    const LocalStar local = local_star(gateways);
    CAPTURE(local.star.text());
    REQUIRE(local.star.size() == 4);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t opposite = local.star.opposite(local.arm_of_gateway[i]);
      CHECK(local.star.has_gateway(opposite) == (gateways[i].middle != off.middle));
    }
  }
  // Without its rival it is good enough.
  CHECK(is_on_path(local_star({west, off})));
}

TEST_CASE("a path bends no more than asked for", "[perception]") {
  const LocalStarOptions options{.slack_rad = 0.5, .max_bend_rad = 0.6};
  CHECK(is_on_path(local_star(all_at({0, 180 - 33}), options)));
  CHECK_FALSE(is_on_path(local_star(all_at({0, 180 - 36}), options)));
}

// Two corridors side by side: they face away from each other but miss by a metre and more.
TEST_CASE("gateways that miss each other are two paths", "[perception]") {
  const Gateway east{{2, 1.5}, 0, 1};
  const Gateway west{{-2, -1.5}, pi, 1};
  CHECK(local_star({east, west}).star.size() == 4);
  // The slack reaches: 2.5 m aside after 4 m would be 32°, less than that crosses.
  CHECK(local_star({east, west}, {.slack_rad = 0.6}).star.size() == 2);
  CHECK(is_on_path(local_star({{{2, 0.3}, 0, 1}, {{-2, -0.1}, pi, 1}})));
}

TEST_CASE("on a path there are two gateways and one path", "[perception]") {
  CHECK(is_on_path(local_star(all_at({0, 180}))));
  CHECK_FALSE(is_on_path(local_star(all_at({0}))));
  CHECK_FALSE(is_on_path(local_star(all_at({0, 90}))));
  CHECK_FALSE(is_on_path(local_star(all_at({0, 90, 180}))));
}

TEST_CASE("past z, labels take numbers", "[perception]") {
  // Nearly all on one side, so that none has its continuation.
  std::vector<Gateway> gateways;
  for (int i = 0; i < 30; ++i) gateways.push_back(at(i * 4, 0.1));
  const LocalStar local = local_star(gateways);
  CHECK(local.star.size() == 60);
  CHECK(local.star.find("z+"));
  CHECK(local.star.find("a1+"));
  CHECK(local.star.find("d1-"));
  CHECK_FALSE(local.star.find("e1+"));
}

TEST_CASE("a star turns with its gateways, listed in any order", "[perception][property]") {
  RandomEngine random(2);
  for (int place = 0; place < 200; ++place) {
    std::vector<Gateway> gateways;
    double degrees = between(0, 360, random);
    for (std::size_t left = 1 + below(5, random); left > 0; --left) {
      gateways.push_back(at(degrees));
      degrees += between(40, 80, random);
    }
    const LocalStar before = local_star(gateways);
    const double angle_rad = between(-pi, pi, random);
    std::vector<Gateway> turned;
    std::vector<Gateway> mirrored;
    for (const Gateway& gateway : gateways) {
      turned.push_back({Pose2{3, -1, angle_rad} * gateway.middle,
                        wrapped(gateway.outward_rad + angle_rad), gateway.width_m});
      mirrored.push_back(
          {{gateway.middle.x_m, -gateway.middle.y_m}, -gateway.outward_rad, gateway.width_m});
    }
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    CAPTURE(place, before.star.text(), local_star(turned).star.text());
    REQUIRE(same(local_star(turned).star, before.star));
    std::vector<Arm> arms;
    for (std::size_t i = before.star.size(); i-- > 0;) arms.push_back(before.star.arm(i));
    REQUIRE(same(local_star(mirrored).star, Star(arms)));
  }
}

}  // namespace asterism
