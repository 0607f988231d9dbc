#include "mapping/kept_perception.hpp"

#include <filesystem>
#include <fstream>
#include <utility>

#include "core/error.hpp"
#include "io/json/trace_file.hpp"
#include "mapping/log_files.hpp"
#include "tests/io/folder.hpp"
#include "tests/mapping/office_drive.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;

const ReadWatch unwatched = [](const LogReader&, const Perceived&) {};

void check_same(const Perceived& one, const Perceived& other) {
  CHECK(one.trace.name == other.trace.name);
  CHECK(one.trace.visits == other.trace.visits);
  CHECK(one.place_maps == other.place_maps);
  CHECK(one.scans.size() == other.scans.size());
  CHECK(one.remarks == other.remarks);
  REQUIRE(one.poses.size() == other.poses.size());
  for (std::size_t i = 0; i < one.poses.size(); ++i) {
    CHECK(one.poses[i].stamp_s == other.poses[i].stamp_s);
    CHECK(one.poses[i].map_from_robot == other.poses[i].map_from_robot);
  }
}

/// Perceived once.
const Perceived& perceived_now() {
  static const Perceived perceived = perceive(log_of_drive());
  return perceived;
}

/// Of the log, with the options given.
std::optional<Perceived> before(const fs::path& results, const ScanDetectorOptions& options = {},
                                const LogOptions& laser = {}) {
  return perceived_before(results, log_of_drive(), laser, options, unwatched);
}

}  // namespace

TEST_CASE("what was perceived is taken up as it was, or not at all", "[mapping][slow]") {
  const Folder folder;
  const fs::path results = folder.file("out");
  CHECK_FALSE(before(results));
  fs::create_directory(results);
  keep_perceived(results, perceived_now());
  const auto kept = before(results);
  REQUIRE(kept);
  CHECK(kept->is_kept);
  CHECK(kept->by == perceived_now().by);
  check_same(*kept, perceived_now());

  SECTION("by other options") {
    ScanDetectorOptions options;
    options.topology.skeleton.min_gateway_width_m += 0.01;
    CHECK_FALSE(before(results, options));
    CHECK_FALSE(before(results, {}, {.max_range_m = 4}));
  }
  SECTION("of another log") {
    const std::string other = folder.file("office.log");
    std::ifstream in(log_of_drive());
    std::ofstream out(other);
    std::string line, last;
    while (std::getline(in, line)) {
      if (!last.empty()) out << last << '\n';
      last = line;
    }
    out.close();
    CHECK_FALSE(perceived_before(results, other, {}, {}, unwatched));
    CHECK_THROWS_AS(
        perceived_as_told({(results / "log.trace.json").string(), (results / "log.lpm").string()},
                          other, {}, unwatched),
        InputError);
  }
  SECTION("edited by hand") {
    Trace trace = read_trace_file((results / "log.trace.json").string());
    trace.visits[1].gateways.clear();
    write_trace_file((results / "log.trace.json").string(), trace);
    CHECK_THROWS_WITH(before(results), Contains("found a trace that was changed"));
  }
  SECTION("damaged") {
    const auto [file, text] =
        GENERATE(std::pair("log.lpm/perception.json", "{"), std::pair("log.lpm/visit-0.json", "{"),
                 std::pair("log.trace.json", ""));
    std::ofstream(results / file) << text;
    CHECK_FALSE(before(results));
  }
  SECTION("gone") {
    fs::remove(results / "log.lpm/visit-1.png");
    CHECK_FALSE(before(results));
  }
}

TEST_CASE("a trace that is told takes the place of the one perceived", "[mapping][slow]") {
  const Folder folder;
  const fs::path results = folder.file("out");
  fs::create_directory(results);
  keep_perceived(results, perceived_now());
  Trace trace = read_trace_file((results / "log.trace.json").string());
  const auto told = [&] {
    const std::string file = folder.file("told.trace.json");
    write_trace_file(file, trace);
    return perceived_as_told({file, (results / "log.lpm").string()}, log_of_drive(), {}, unwatched);
  };
  const auto refused = [&] {
    try {
      told();
    } catch (const InputError& error) {
      const std::string text = error.what();
      return text.substr(text.find("told.trace.json") + 15);
    }
    return std::string("taken");
  };
  SECTION("the same") { check_same(told(), perceived_now()); }
  SECTION("one visit less") {
    trace.visits.pop_back();
    trace.visits.back().left_by.reset();
    const Perceived perceived = told();
    CHECK(perceived.trace.visits.size() == 3);
    CHECK(perceived.place_maps.size() == 3);
    // It is not taken for what the log shows.
    const fs::path corrected = folder.file("corrected");
    fs::create_directory(corrected);
    keep_perceived(corrected, perceived);
    CHECK_THROWS_WITH(before(corrected), Contains("found a trace that was told"));
  }
  SECTION("a visit without a place map") {
    trace.visits[1].lpm.reset();
    CHECK_FALSE(told().place_maps[1]);
  }
  SECTION("no displacement") {
    trace.visits[2].displacement.reset();
    CHECK(refused() ==
          ":/visits/2/displacement: found nothing; expected that from the visit before");
  }
  SECTION("a displacement that is known without error") {
    trace.visits[2].displacement->covariance = {};
    CHECK(
        refused().starts_with(":/visits/2/displacement: found one that no layout can be made of"));
  }
  SECTION("no scans") {
    trace.visits[0].scans.reset();
    CHECK(refused() ==
          ":/visits/0/scans: found nothing; expected the first and the last scan of the visit");
  }
  SECTION("scans beyond the log, or out of order") {
    (*trace.visits[3].scans)[1] = 1'000'000;
    CHECK(refused().starts_with(":/visits/3/scans: found "));
    trace.visits[3].scans = trace.visits[0].scans;
    CHECK(refused().starts_with(":/visits/3/scans: found "));
  }
  SECTION("no map folder") {
    const std::string file = (results / "log.trace.json").string();
    CHECK_THROWS_WITH(perceived_as_told({file, folder.file("none")}, log_of_drive(), {}, unwatched),
                      Contains("found no perception.json; expected --lpm"));
    CHECK_THROWS_WITH(perceived_as_told({folder.file("none.trace.json"), folder.file("none")},
                                        log_of_drive(), {}, unwatched),
                      Contains("none.trace.json: found no such file"));
  }
  SECTION("a place map that is not there") {
    trace.visits[1].lpm = "log.lpm/visit-77.json";
    CHECK_THROWS_AS(told(), InputError);
  }
}

TEST_CASE("a map from what was kept is the map of the whole run", "[mapping][slow]") {
  const Folder folder;
  const fs::path results = folder.file("out");
  fs::create_directory(results);
  LogMaps whole = map_log(log_of_drive(), {.resolution_m = 0.2});
  keep_perceived(results, whole.perceived);
  LogMaps kept = map_log(log_of_drive(), {.results_before = results, .resolution_m = 0.2});
  CHECK(kept.perceived.is_kept);
  REQUIRE(kept.models.size() == whole.models.size());
  for (std::size_t i = 0; i < whole.models.size(); ++i) {
    CHECK(kept.models[i].global_map == whole.models[i].global_map);
    CHECK(kept.models[i].trajectory == whole.models[i].trajectory);
  }
  CHECK(run_report_html(run_report_of(std::move(kept))) ==
        run_report_html(run_report_of(std::move(whole))));
}

}  // namespace asterism
