#include "io/maps_file.hpp"

#include <limits>
#include <sstream>

#include "core/error.hpp"
#include "io/trace_file.hpp"
#include "tests/io/corpus.hpp"
#include "tests/io/same.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

std::string text_of(const MapReport& report) {
  std::ostringstream out;
  write_maps(out, report);
  return out.str();
}

//  0 ---- 1     the corner: out of 0 by a+, into 1 by c-, out by d+, into 2 by a+
//         |
//         2
MapReport corner() {
  const Trace trace = read_trace_file(std::string(ASTERISM_SOURCE_DIR) +
                                      "/tests/corpus/trace/good/corner.trace.json");
  const std::vector<Arrival> arrivals{
      {PlaceId(0), std::nullopt}, {PlaceId(1), 2U}, {PlaceId(2), 0U}};
  MapReport report;
  report.trace = trace.name;
  report.consistent = 1;
  report.per_visit = {1, 1, 1};
  report.minimal = {3, 3, 1, true};
  report.maps = {make_map(trace, arrivals)};
  return report;
}

}  // namespace

TEST_CASE("a maps file is written key by key, one line a part of a map", "[io]") {
  CHECK(text_of(corner()) ==
        content(std::string(ASTERISM_SOURCE_DIR) + "/tests/corpus/maps/good/corner.maps.json"));
}

TEST_CASE("every good maps file is read and written without loss", "[io]") {
  for (const auto& file : good_files("maps")) {
    INFO(file);
    const MapReport report = read_maps_file(file);
    const std::string text = text_of(report);
    CHECK(same(read_maps(text, "again"), report));
    CHECK(text_of(read_maps(text, "again")) == text);
  }
}

TEST_CASE("every bad maps file is refused, and the message says where and why", "[io]") {
  const auto files = bad_files("maps");
  CHECK(files.size() >= 20);
  for (const auto& [file, message] : files) {
    INFO(file);
    CHECK_THROWS_AS(read_maps(content(file), "file"), InputError);
    CHECK_THROWS_WITH(read_maps_file(file), file.string() + message);
  }
}

TEST_CASE("reports are read as they were written", "[io]") {
  MapReport report = corner();
  SECTION("as it is") {}
  SECTION("options") {
    report.options = {.planar = true,
                      .check = "solver",
                      .axioms = "my \"axioms\"",
                      .optional_axioms = {"one_segment"},
                      .preference = {"place", "path"},
                      .certify_s = 0.1,
                      .max_hypotheses = std::numeric_limits<std::uint64_t>::max(),
                      .time_limit_s = 1e-3,
                      .all = true};
  }
  SECTION("stopped") {
    report.complete = false;
    report.stopped_by = "time_limit_s";
    report.per_visit = {1, 1};
  }
  SECTION("nothing listed") {
    report.consistent.reset();
    report.per_visit.reset();
    report.minimal->certified = false;
  }
  SECTION("nothing consistent") {
    report.consistent = 0;
    report.per_visit = {1, 1, 0};
    report.minimal.reset();
    report.maps.clear();
  }
  CHECK(same(read_maps(text_of(report), "again"), report));
}

TEST_CASE("what is not UTF-8 or no number is not written", "[io]") {
  MapReport report = corner();
  SECTION("name") { report.trace = "latin 1: \xff"; }
  SECTION("axioms") { report.options.axioms = "cut short: \xc3"; }
  SECTION("infinite") { report.options.certify_s = std::numeric_limits<double>::infinity(); }
  CHECK_THROWS_AS(text_of(report), std::invalid_argument);
}

TEST_CASE("a maps file may be long", "[io]") {
  MapReport report = corner();
  report.options.all = true;
  report.consistent.reset();
  report.per_visit.reset();
  // Any arrangement of the visits among places seen alike, in the order that a file has.
  const Trace trace = [] {
    Trace steps{"steps", {}};
    for (int k = 0; k < 9; ++k)
      steps.visits.push_back(
          {.star = Star::parse("a+1 b+1 a-1 b-1"), .entered_by = 2U, .left_by = 0U});
    return steps;
  }();
  report.maps.clear();
  for (std::size_t back = 0; back < 8; ++back) {
    std::vector<Arrival> arrivals;
    for (std::size_t k = 0; k < 8; ++k) arrivals.push_back({PlaceId(k), 2U});
    arrivals.push_back({PlaceId(back), back == 0 ? 2U : 3U});
    report.maps.push_back(make_map(trace, arrivals));
  }
  CHECK(same(read_maps(text_of(report), "again"), report));
}

}  // namespace asterism
