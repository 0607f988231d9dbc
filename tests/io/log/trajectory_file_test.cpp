#include "io/log/trajectory_file.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "core/error.hpp"
#include "core/random.hpp"
#include "tests/io/corpus.hpp"
#include "tests/io/folder.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double rounding_rad = 1e-14;  // of a half angle's sine, cosine and arc tangent

std::unique_ptr<std::istream> stream(const std::string& text) {
  return std::make_unique<std::istringstream>(text);
}

std::string good(const std::string& kind, const std::string& name) {
  return std::string(ASTERISM_SOURCE_DIR) + "/tests/corpus/" + kind + "/good/" + name;
}

std::string written(const Trajectory& trajectory) {
  std::ostringstream out;
  write_trajectory(out, trajectory);
  return out.str();
}

bool same(const Trajectory& a, const Trajectory& b) {
  return std::ranges::equal(a, b, [](const TimedPose& x, const TimedPose& y) {
    const Pose2 p = x.layout_from_robot, q = y.layout_from_robot;
    return x.stamp_s == y.stamp_s && p.position() == q.position() &&
           std::abs(wrapped(p.heading_rad - q.heading_rad)) <= rounding_rad;
  });
}

}  // namespace

TEST_CASE("every bad trajectory is refused, and the message says where and why", "[io]") {
  CHECK_THROWS_WITH(read_trajectory_file("no/such.tum"),
                    "no/such.tum: found no such file or directory; expected a file that can be "
                    "read");
}

TEST_CASE("every good trajectory is read and, written, read again", "[io]") {
  for (const auto& file : good_files("tum")) {
    INFO(file);
    const Trajectory trajectory = read_trajectory_file(file);
    CHECK(same(read_trajectory(stream(written(trajectory)), "again"), trajectory));
  }
  for (const auto& file : good_files("reference")) CHECK(read_reference_file(file).size() == 2);
}

TEST_CASE("a line in TUM format is a pose, its heading about the vertical", "[io]") {
  const Trajectory trajectory = read_trajectory_file(good("tum", "two.tum"));
  REQUIRE(trajectory.size() == 2);
  CHECK(trajectory[0] == TimedPose{976052857.337534, {0, 0, 0}});
  CHECK(trajectory[1].stamp_s == 976052857.437534);
  CHECK(trajectory[1].layout_from_robot.position() == Point2{1.5, -2.25});
  CHECK(trajectory[1].layout_from_robot.heading_rad == Approx(pi / 2));
  const auto back = read_trajectory_file(good("tum", "back_in_time.tum"));
  CHECK(back[0].stamp_s > back[1].stamp_s);
  CHECK(back[0].layout_from_robot.heading_rad == Approx(pi));
  // The quaternion and its negative are one turn.
  CHECK(back[1].layout_from_robot.heading_rad == Approx(2 * std::atan2(-0.6, 0.8)));
  for (const char* packed : {"packed.tum.xz", "packed.tum.gz"})
    CHECK(read_trajectory_file(good("tum", packed)) == trajectory);
}

TEST_CASE("of a reference, the poses of kind K are read", "[io]") {
  for (const char* name : {"four_scans.txt", "packed.txt.xz"}) {
    const Trajectory reference = read_reference_file(good("reference", name));
    REQUIRE(reference.size() == 2);
    CHECK(reference[0] == TimedPose{1.7, {0.25, 0, 0.1}});
    CHECK(reference[1] == TimedPose{1.9, {0.5, -1, wrapped(7)}});
  }
  CHECK(read_reference_file(good("reference", "as_trajectory.tum")) ==
        read_trajectory_file(good("tum", "two.tum")));
}

TEST_CASE("a written trajectory has a line a pose, stamps to the microsecond", "[io]") {
  CHECK(written({{976052857.337534, {0, 0, 0}}, {1e9, {-1e-7, 0.1, pi}}}) ==
        "# stamp tx ty tz qx qy qz qw\n976052857.337534 0 0 0 0 0 0 1\n"
        "1000000000 -0.0000001 0.1 0 0 0 1 0.00000000000000006123233995736766\n");
}

TEST_CASE("a trajectory is read as it was written", "[io][property]") {
  RandomEngine random(GENERATE(range(0U, 30U)));
  Trajectory trajectory;
  for (std::size_t i = 0; i <= below(40, random); ++i)
    trajectory.push_back(
        {between(-1e9, 1e10, random),
         {between(-1e4, 1e4, random), normal(random) * 1e-9, wrapped(between(-pi, pi, random))}});
  const Folder folder;
  const std::string file = folder.file("drive.tum");
  write_trajectory_file(file, trajectory);
  CHECK(folder.entries() == 1);
  CHECK(content(file) == written(trajectory));
  CHECK(same(read_trajectory_file(file), trajectory));
}

TEST_CASE("a trajectory that could not be read back is not written", "[io]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Trajectory trajectory(2);
  SECTION("no pose") { trajectory.clear(); }
  SECTION("stamp infinite") { trajectory[1].stamp_s = HUGE_VAL; }
  SECTION("position no number") { trajectory[1].layout_from_robot.y_m = nan; }
  SECTION("position beyond bounds") { trajectory[0].layout_from_robot.x_m = 2e7; }
  SECTION("heading no number") { trajectory[1].layout_from_robot.heading_rad = nan; }
  const Folder folder;
  CHECK_THROWS_AS(write_trajectory_file(folder.file("drive.tum"), trajectory),
                  std::invalid_argument);
  CHECK(folder.entries() == 0);
}

}  // namespace asterism
