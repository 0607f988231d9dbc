#include "io/json/detector_lines.hpp"

#include <limits>

#include "core/error.hpp"
#include "io/json/trace_file.hpp"
#include "tests/io/corpus.hpp"
#include "tests/support/catch.hpp"

namespace asterism {

TEST_CASE("a scan is written as one line of JSON", "[io]") {
  const Scan scan{17, 8.5, {1.25, 0, 0.1}, {1.02, 1.03, 8}, {-1.5, 0.25, 8, {0.1, 0, 0}}};
  CHECK(scan_line(scan) ==
        R"({"scan": 17, "stamp_s": 8.5, "odometry": [1.25, 0, 0.1], "first_beam_rad": -1.5, )"
        R"("beam_step_rad": 0.25, "max_range_m": 8, "robot_from_laser": [0.1, 0, 0], )"
        R"("ranges_m": [1.02, 1.03, 8]})");
}

TEST_CASE("a scan with a number that is not finite is refused", "[io]") {
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(scan_line({.ranges_m = {1, infinity}}), std::invalid_argument);
}

TEST_CASE("a visit's line is the visit of a trace", "[io]") {
  for (const auto& file : good_files("detector_lines")) {
    INFO(file);
    const std::string line = content(file);
    const Visit visit = read_visit_line(line, "command:line 3");
    const std::string before = R"({"star": "a+1 a-1", "left_by": "a+"}, )";
    const std::string after = R"(, {"star": "a+1 a-1", "entered_by": "a+"})";
    const bool is_first = !visit.entered_by, is_last = !visit.left_by;
    const std::string trace =
        R"({"format": "asterism/trace", "version": 1, "name": "", "visits": [)" +
        (is_first ? "" : before) + line + (is_last ? "" : after) + "]}";
    CHECK(read_trace(trace, "trace").visits[is_first ? 0 : 1] == visit);
  }
}

TEST_CASE("a line that is no visit is refused, and the message says where and why", "[io]") {
  const auto files = bad_files("detector_lines");
  CHECK(files.size() >= 25);
  for (const auto& [file, message] : files) {
    INFO(file);
    std::string complaint;
    try {
      read_visit_line(content(file), "command:line 3");
    } catch (const InputError& error) {
      complaint = error.what();
    }
    CHECK(complaint == "command:line 3" + message);
  }
}

}  // namespace asterism
