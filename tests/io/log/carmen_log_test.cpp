#include "io/log/carmen_log.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <numbers>
#include <random>
#include <sstream>

#include "core/error.hpp"
#include "tests/io/corpus.hpp"
#include "tests/io/folder.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

namespace fs = std::filesystem;

constexpr double degree_rad = std::numbers::pi / 180;
constexpr double rounding = 1e-12;  // of a few operations on doubles about 1

Approx about(double value) { return Approx(value).margin(rounding).epsilon(rounding); }

std::vector<Scan> rest(LogReader reader) {
  std::vector<Scan> scans;
  while (auto scan = reader.next()) scans.push_back(std::move(*scan));
  return scans;
}

std::vector<Scan> scans_of(const std::string& text, const LogOptions& options = {}) {
  return rest(LogReader(std::make_unique<std::istringstream>(text), "log", options));
}

std::vector<Scan> good(const std::string& name) {
  return rest(LogReader(std::string(ASTERISM_SOURCE_DIR) + "/tests/corpus/carmen/good/" + name));
}

std::string flaser(const std::string& ranges, std::size_t count) {
  return "FLASER " + std::to_string(count) + ' ' + ranges + " 9 9 9 1 2 0.5 10.5 host 7\n";
}
std::string flaser(std::size_t count) {
  std::string ranges;
  for (std::size_t i = 0; i < count; ++i) ranges += (i == 0 ? "" : " ") + std::string("1.25");
  return flaser(ranges, count);
}

ScanSource source(std::vector<Scan> scans) {
  return [scans = std::move(scans), next = std::size_t{0}]() mutable -> std::optional<Scan> {
    if (next == scans.size()) return std::nullopt;
    return scans[next++];
  };
}

std::string written(std::vector<Scan> scans) {
  std::ostringstream out;
  write_carmen_log(out, source(std::move(scans)));
  return out.str();
}

bool same_scan(const Scan& a, const Scan& b) {
  return a.number == b.number && a.stamp_s == b.stamp_s && a.odom_from_robot == b.odom_from_robot &&
         a.ranges_m == b.ranges_m;
}

void check_layout(const LaserLayout& found, const LaserLayout& expected) {
  CHECK(found.first_beam_rad == about(expected.first_beam_rad));
  CHECK(found.beam_step_rad == about(expected.beam_step_rad));
  CHECK(found.max_range_m == about(expected.max_range_m));
  CHECK(found.robot_from_laser.x_m == about(expected.robot_from_laser.x_m));
  CHECK(found.robot_from_laser.y_m == about(expected.robot_from_laser.y_m));
  CHECK(found.robot_from_laser.heading_rad == about(expected.robot_from_laser.heading_rad));
}

}  // namespace

TEST_CASE("every bad log is refused, and the message says where and why", "[io]") {
  const auto files = bad_files("carmen");
  CHECK(files.size() >= 40);
  for (const auto& [file, message] : files) {
    INFO(file);
    CHECK_THROWS_WITH(rest(LogReader(file.string())), file.string() + message);
    CHECK_THROWS_AS(scans_of(content(file)), InputError);
  }
}

TEST_CASE("every good log is read and, written, read again", "[io]") {
  for (const auto& file : good_files("carmen")) {
    INFO(file);
    LogReader reader(file.string());
    CHECK(reader.bytes_total() == fs::file_size(file));
    std::vector<Scan> scans;
    while (const auto scan = reader.next()) {
      CHECK(scan->number == std::ssize(scans));
      scans.push_back(*scan);
    }
    CHECK(reader.bytes_read() == fs::file_size(file));
    CHECK_FALSE(reader.next());
    for (Scan& scan : scans) scan.laser = {-1, 1, 20, {}};  // one layout, and no odd beams
    for (Scan& scan : scans)
      scan.laser.first_beam_rad = -(static_cast<double>(scan.ranges_m.size()) - 1) / 2;
    std::erase_if(scans, [&](const Scan& scan) {
      return scan.ranges_m.size() != scans.front().ranges_m.size();
    });
    const auto again = scans_of(written(scans));
    REQUIRE(again.size() == scans.size());
    for (std::size_t i = 0; i < scans.size(); ++i) {
      scans[i].number = static_cast<long long>(i);
      CHECK(same_scan(again[i], scans[i]));
    }
  }
}

TEST_CASE("a packed log says what the plain one does", "[io]") {
  const auto plain = good("flaser.log");
  REQUIRE(plain.size() == 40);
  for (const char* name :
       {"flaser.log.gz", "flaser.log.xz", "flaser_members.log.gz", "flaser_streams.log.xz"}) {
    INFO(name);
    const auto packed = good(name);
    REQUIRE(packed.size() == plain.size());
    for (std::size_t i = 0; i < plain.size(); ++i) CHECK(same_scan(packed[i], plain[i]));
  }
}

TEST_CASE("what an FLASER line says is in the scan", "[io]") {
  const auto scans = scans_of("FLASER 3 1.5 0 50 7 8 9 1 -2 3.5 12.25 host 3\n" + flaser(3));
  REQUIRE(scans.size() == 2);
  const Scan& scan = scans.front();
  CHECK(scan.number == 0);
  CHECK(scans.back().number == 1);
  CHECK(scan.stamp_s == 12.25);
  CHECK(scans.back().stamp_s == 10.5);  // earlier, but later in the file
  CHECK(scan.ranges_m == std::vector<double>{1.5, 0, 50});
  CHECK(scan.odom_from_robot.position() == Point2{1, -2});
  CHECK(scan.odom_from_robot.heading_rad == about(3.5 - 2 * std::numbers::pi));
  check_layout(scan.laser, {-90 * degree_rad, 90 * degree_rad, 50, {}});
}

TEST_CASE("what a ROBOTLASER1 line says is in the scan", "[io]") {
  const auto scans = good("robotlaser.log");
  REQUIRE(scans.size() == 2);
  CHECK(scans[0].ranges_m == std::vector<double>{1.5, 2.5, 81.91});
  CHECK(scans[0].odom_from_robot == Pose2{1, 2, 0.5});
  CHECK(scans[0].stamp_s == 10.5);
  check_layout(scans[0].laser,
               {-1.570796, 1.570796, 81.83, {0.1 * std::cos(0.5), -0.1 * std::sin(0.5), 0}});
  CHECK(scans[1].ranges_m == std::vector<double>{4.25});
  check_layout(scans[1].laser, {-1.570796, 1.570796, 81.83, {0, 0, 1}});
}

TEST_CASE("of a log with scans of both kinds, those of the first kind are read", "[io]") {
  const auto scans = good("both_kinds.log");
  REQUIRE(scans.size() == 2);
  CHECK(scans[1].laser.max_range_m == 50);
}

TEST_CASE("blanks, line ends and comments do not matter", "[io]") {
  const auto scans = good("carriage_returns_and_tabs.log");
  REQUIRE(scans.size() == 3);
  CHECK(scans[0].ranges_m == scans[1].ranges_m);
  CHECK(scans[2].odom_from_robot.heading_rad == about(9.5 - 4 * std::numbers::pi));
}

TEST_CASE("the number of beams says how they lie", "[io]") {
  struct Case {
    std::size_t beams;
    double first_deg, step_deg;
  };
  const auto [beams, first_deg, step_deg] = GENERATE(
      Case{1, 0, 0}, Case{2, -90, 180}, Case{101, -50, 1}, Case{180, -90, 1}, Case{181, -90, 1},
      Case{201, -50, 0.5}, Case{360, -90, 0.5}, Case{361, -90, 0.5}, Case{400, -50, 0.25},
      Case{401, -50, 0.25}, Case{91, -90, 2}, Case{541, -90, 1. / 3});
  CAPTURE(beams);
  const auto scans = scans_of(flaser(beams));
  REQUIRE(scans.front().ranges_m.size() == beams);
  check_layout(scans.front().laser, {first_deg * degree_rad, step_deg * degree_rad, 50, {}});
}

TEST_CASE("parameters of the log say how the beams lie", "[io]") {
  const auto scans = good("parameters.log");
  check_layout(scans.front().laser, {-0.5 * degree_rad, 0.5 * degree_rad, 81.83, {0.1, -0.2, 0.3}});
}

TEST_CASE("options overrule the log", "[io]") {
  const LogOptions options{
      .field_of_view_rad = 2, .max_range_m = 7, .robot_from_laser = {{1, 2, 3}}};
  const auto robotlaser =
      content(fs::path(ASTERISM_SOURCE_DIR) / "tests/corpus/carmen/good/robotlaser.log");
  const std::string parameters =
      "PARAM robot_front_laser_max 30\nPARAM laser_front_laser_resolution 5\n"
      "PARAM robot_frontlaser_offset 0.3\n";
  for (const std::string& text : {parameters + flaser(3), robotlaser})
    check_layout(scans_of(text, options).front().laser, {-1, 1, 7, {1, 2, 3}});
  check_layout(scans_of(flaser(3), {.field_of_view_rad = 2, .first_beam_rad = 0.25}).front().laser,
               {0.25, 1, 50, {}});
  check_layout(scans_of(flaser(180), {.first_beam_rad = 0}).front().laser, {0, degree_rad, 50, {}});
}

TEST_CASE("options that say nothing possible are refused", "[io]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  LogOptions options;
  SECTION("no field of view") { options.field_of_view_rad = 0; }
  SECTION("more than all round") { options.field_of_view_rad = 7; }
  SECTION("field of view no number") { options.field_of_view_rad = nan; }
  SECTION("first beam no number") { options.first_beam_rad = nan; }
  SECTION("no range") { options.max_range_m = 0; }
  SECTION("all ranges") { options.max_range_m = HUGE_VAL; }
  SECTION("offset no number") { options.robot_from_laser = {0, 0, nan}; }
  CHECK_THROWS_AS(scans_of(flaser(3), options), std::invalid_argument);
}

TEST_CASE("8.183 m is no return where ranges are in millimetres and none is beyond", "[io]") {
  std::vector<double> max_ranges_m;
  for (const Scan& scan : good("millimetres.log")) max_ranges_m.push_back(scan.laser.max_range_m);
  CHECK(max_ranges_m == std::vector<double>{50, 8.183, 8.183, 50, 50});
}

TEST_CASE("a maximum range that is said is kept, but for the codes of no return", "[io]") {
  const auto max_range_m = [](const std::string& stated) {
    return scans_of("PARAM robot_front_laser_max " + stated + '\n' + flaser(3))
        .front()
        .laser.max_range_m;
  };
  CHECK(max_range_m("5.6") == 5.6);
  CHECK(max_range_m("8.19") == 8.183);
  CHECK(max_range_m("8.2") == 8.2);
  CHECK(max_range_m("50") == 50);
  CHECK(max_range_m("81.8") == 81.8);
  CHECK(max_range_m("81.920") == about(81.83));
  CHECK(max_range_m("100") == 100);
}

TEST_CASE("what is no file is no log", "[io]") {
  CHECK_THROWS_WITH(
      LogReader("no/such.log"),
      "no/such.log: found no such file or directory; expected a file that can be read");
  CHECK_THROWS_WITH(LogReader(ASTERISM_SOURCE_DIR),
                    ASTERISM_SOURCE_DIR ": found a directory; expected a file");
  CHECK_THROWS_WITH(
      LogReader("/dev/zero").next(),
      "/dev/zero:1: found a line of more than 1048576 bytes; expected a shorter line");
  CHECK_FALSE(LogReader("/dev/null").bytes_total());
}

TEST_CASE("a written log is read back as it was", "[io][property]") {
  const auto seed = GENERATE(range(0U, 60U));
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const auto share = [&] { return static_cast<double>(random() >> 11) / 0x1p53; };
  const std::array<std::size_t, 6> counts{1, 17, 180, 181, 361, 682};
  const std::size_t beams = counts[seed % counts.size()];
  LaserLayout laser{0, 0, 1 + 6 * share(), {share(), -share(), 3 * share() - 1}};
  if (beams > 1) laser.beam_step_rad = (beams == 180 ? 1 : share() + 0.01) * degree_rad;
  laser.first_beam_rad =
      -static_cast<double>(beams == 180 ? beams : beams - 1) * laser.beam_step_rad / 2;
  std::vector<Scan> scans;
  for (int i = 0; i < 5; ++i) {
    Scan scan{i, 1e9 * share(), {1e4 * share(), -share(), 6 * share() - 3}, {}, laser};
    while (scan.ranges_m.size() < beams) scan.ranges_m.push_back(10 * share());
    scans.push_back(scan);
  }

  const Folder folder;
  const std::string file = folder.file("drive.log");
  write_carmen_log(file, source(scans));
  CHECK(content(file) == written(scans));
  const auto again = rest(LogReader(file));
  REQUIRE(again.size() == scans.size());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    CHECK(same_scan(again[i], scans[i]));
    check_layout(again[i].laser, laser);
  }
}

TEST_CASE("a log that could not be read back is not written", "[io]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Scan> scans(2, Scan{0, 0, {}, {1, 2, 3}, {-1, 1, 8, {}}});
  CHECK_NOTHROW(written(scans));
  Scan& scan = scans.back();
  SECTION("no scan") { scans.clear(); }
  SECTION("no range") { scan.ranges_m.clear(); }
  SECTION("range no number") { scan.ranges_m[1] = nan; }
  SECTION("range negative") { scan.ranges_m[1] = -1; }
  SECTION("range infinite") { scan.ranges_m[1] = HUGE_VAL; }
  SECTION("stamp no number") { scan.stamp_s = nan; }
  SECTION("position no number") { scan.odom_from_robot.x_m = nan; }
  SECTION("position beyond bounds") { scan.odom_from_robot.y_m = -2e7; }
  SECTION("heading infinite") { scan.odom_from_robot.heading_rad = HUGE_VAL; }
  SECTION("layouts differ") { scan.laser.max_range_m = 9; }
  SECTION("another number of beams") { scan.ranges_m.push_back(4); }
  SECTION("beams off centre") { scans[0].laser.first_beam_rad = scan.laser.first_beam_rad = 0; }
  SECTION("no step") { scans[0].laser = scan.laser = {0, 0, 8, {}}; }
  SECTION("no maximum range") { scans[0].laser = scan.laser = {-1, 1, 0, {}}; }
  SECTION("laser far off") { scans[0].laser = scan.laser = {-1, 1, 8, {1000, 0, 0}}; }
  const Folder folder;
  CHECK_THROWS_AS(written(scans), std::invalid_argument);
  CHECK_THROWS_AS(write_carmen_log(folder.file("drive.log"), source(scans)), std::invalid_argument);
  CHECK(folder.entries() == 0);
}

}  // namespace asterism
