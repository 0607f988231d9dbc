#include <cstdlib>
#include <filesystem>

#include "io/log/carmen_log.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

namespace fs = std::filesystem;

/// Logs of real drives, which are no part of these sources.
fs::path data_folder() {
  const char* const folder = std::getenv("ASTERISM_DATA");
  return folder ? fs::path(folder) : fs::path(ASTERISM_SOURCE_DIR).parent_path() / "shared/data";
}

struct Drive {
  std::string name;
  long long scans;
  std::size_t beams;
  double max_range_m;        ///< as the rules of LogReader have it
  double farthest_return_m;  ///< below it
  double nearest_no_return_m;
  long long no_returns;
  double length_m;
  int steps_back;  ///< of the stamps
};

}  // namespace

TEST_CASE("the logs of real drives are read whole", "[io]") {
  const auto drive = GENERATE(values<Drive>({
      {"aces", 7374, 180, 50, 49.91, 50, 11137, 325, 0},
      {"intel", 13631, 180, 50, 26.37, 81.83, 68313, 508, 897},
      {"mit_csail", 1988, 361, 50, 42.4, 81.91, 23711, 374, 0},
      {"duke_loop5", 551, 181, 8.183, 8.178, 8.183, 6726, 56, 0},
      {"seattle", 241, 361, 50, 40.66, 81.87, 707, 190, 0},
  }));
  CAPTURE(drive.name);
  const fs::path file = data_folder() / drive.name / (drive.name + ".log.xz");
  if (!fs::exists(file)) {
    WARN(file << ": not here, not read");
    return;
  }
  LogReader reader(file.string());
  std::optional<Scan> last;
  long long scans = 0, no_returns = 0;
  double length_m = 0, farthest_return_m = 0, nearest_no_return_m = 1e9;
  int steps_back = 0;
  while (auto scan = reader.next()) {
    REQUIRE(scan->number == scans++);
    REQUIRE(scan->ranges_m.size() == drive.beams);
    REQUIRE(scan->laser.max_range_m == drive.max_range_m);
    for (const double range_m : scan->ranges_m) {
      const bool is_return = range_m < drive.max_range_m;
      if (!is_return) ++no_returns;
      if (is_return) farthest_return_m = std::max(farthest_return_m, range_m);
      if (!is_return) nearest_no_return_m = std::min(nearest_no_return_m, range_m);
    }
    if (last && scan->stamp_s < last->stamp_s) ++steps_back;
    if (last) length_m += norm(scan->odom_from_robot.position() - last->odom_from_robot.position());
    last = std::move(scan);
  }
  CHECK(scans == drive.scans);
  CHECK(reader.bytes_read() == fs::file_size(file));
  CHECK(farthest_return_m == Approx(drive.farthest_return_m).margin(0.005));
  CHECK(nearest_no_return_m == drive.nearest_no_return_m);
  CHECK(no_returns == drive.no_returns);
  CHECK(length_m == Approx(drive.length_m).margin(1));
  CHECK(steps_back == drive.steps_back);
}

}  // namespace asterism
