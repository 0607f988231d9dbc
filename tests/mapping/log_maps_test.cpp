#include "mapping/log_maps.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "io/json/maps_file.hpp"
#include "io/json/trace_file.hpp"
#include "io/log/carmen_log.hpp"
#include "mapping/log_files.hpp"
#include "tests/io/folder.hpp"
#include "tests/mapping/office_drive.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

TEST_CASE("from a log come ranked maps, each with a trajectory and a global map",
          "[mapping][slow]") {
  std::vector<std::string> stages;
  std::size_t scans_read = 0;
  LogWatch watch;
  watch.read = [&](const LogReader&, const Perceived& so_far) { scans_read = so_far.scans.size(); };
  watch.perceived = [&](const Perceived&) { stages.push_back("perceived"); };
  watch.explained = [&](const ExplainedTrace&) { stages.push_back("explained"); };
  watch.ranked = [&](const ExplainedTrace&) { stages.push_back("ranked"); };
  const LogMaps maps = map_log(log_of_drive(), {.resolution_m = 0.2}, watch);
  CHECK(stages == std::vector<std::string>{"perceived", "explained", "ranked"});

  CHECK(maps.perceived.trace.name == "office");
  CHECK(maps.perceived.trace.visits.size() == 4);
  CHECK(maps.perceived.place_maps.size() == 4);
  CHECK(maps.perceived.scans.size() == scans_read);
  CHECK(maps.perceived.poses.size() == scans_read);

  const MapReport& report = maps.explained.report;
  CHECK(report.consistent == 2);
  CHECK(report.minimal->certified);
  REQUIRE(report.ranked.size() == 2);
  // The simpler map does not fit what was measured.
  CHECK(report.ranked[0].is_plausible);
  CHECK_FALSE(report.ranked[1].is_plausible);
  CHECK(report.ranked[1].map.places.size() < report.ranked[0].map.places.size());

  REQUIRE(maps.models.size() == 2);
  for (const DrawnModel& model : maps.models) {
    CHECK(model.trajectory.size() == scans_read);
    CHECK(model.global_map.value().resolution_m == 0.2);
  }
}

TEST_CASE("only the minimal models are ranked where they alone are asked for", "[mapping][slow]") {
  const LogMaps maps = map_log(log_of_drive(), {.only_minimal = true, .resolution_m = 0.2});
  CHECK(maps.explained.maps.are_searched());
  CHECK(maps.explained.report.ranked.size() == 1);
  CHECK(maps.explained.other_per_visit.empty());
}

TEST_CASE("what is assumed holds in all maps of a log, and must name its visits",
          "[mapping][slow]") {
  LogQuestion asked{.resolution_m = 0.2};
  asked.assumptions = {read_assumption("differ(0, 3)")};
  CHECK(map_log(log_of_drive(), asked).explained.report.consistent == 1);
  asked.assumptions = {read_assumption("differ(0, 4)")};
  CHECK_THROWS_AS(map_log(log_of_drive(), asked), InputError);
}

TEST_CASE("the files of a log read back as what was found", "[mapping][slow]") {
  const Folder folder;
  LogMaps maps = map_log(log_of_drive(), {.resolution_m = 0.2});
  const Trace perceived = maps.perceived.trace;
  const std::vector<std::uint64_t> planar_per_visit = maps.explained.other_per_visit;
  const std::filesystem::path out = folder.file("out");
  const RunReport report = write_log_files(out, std::move(maps));
  CHECK(report.decided.size() == 4);
  CHECK(report.planar_per_visit == planar_per_visit);
  const Trace trace = read_trace_file((out / "log.trace.json").string());
  CHECK(trace.visits[3].star == perceived.visits[3].star);
  for (const Visit& visit : trace.visits) CHECK(std::filesystem::exists(out / visit.lpm.value()));
  CHECK(std::get<MapReport>(read_any_maps_file((out / "maps.json").string())).ranked.size() == 2);
  for (const char* name :
       {"report.html", "map.yaml", "trajectory.tum", "layout.g2o", "model-2/trajectory.tum"})
    CHECK(std::filesystem::exists(out / name));
}

TEST_CASE("of a log whose stamps run backwards the order of the scans counts", "[mapping][slow]") {
  const Folder folder;
  const std::string backwards = folder.file("backwards.log");
  LogReader forwards(log_of_drive());
  write_carmen_log(backwards, [&]() -> std::optional<Scan> {
    auto scan = forwards.next();
    if (scan) scan->stamp_s = 1e6 - scan->stamp_s;
    return scan;
  });
  const Perceived other = perceive(log_of_drive());
  const Perceived perceived = perceive(backwards);
  CHECK(other.remarks.empty());
  REQUIRE(perceived.remarks.size() == 1);
  CHECK(perceived.remarks.front() ==
        fmt::format("stamps run backwards at {} of {} scans, first at scan 1: the order of the log "
                    "counts",
                    other.scans.size() - 1, other.scans.size()));
  REQUIRE(perceived.trace.visits.size() == other.trace.visits.size());
  for (std::size_t k = 0; k < other.trace.visits.size(); ++k) {
    Visit visit = perceived.trace.visits[k];
    visit.stamps_s = other.trace.visits[k].stamps_s;
    CHECK(visit == other.trace.visits[k]);
  }
  const std::string file = folder.file("backwards.trace.json");
  write_trace_file(file, perceived.trace);
  CHECK(read_trace_file(file).visits == perceived.trace.visits);
}

TEST_CASE("a map that cannot be drawn costs its own drawing alone", "[mapping][slow]") {
  const LogMaps maps = map_log(log_of_drive(), {.resolution_m = 0.2});
  std::vector<RankedMap> ranked = maps.explained.report.ranked;
  ranked[1].layout.layout_from_place[1].x_m = std::nan("");
  const std::vector<DrawnModel> models = draw_models(maps.perceived, ranked, 0.2);
  REQUIRE(models.size() == 2);
  CHECK(models[0].global_map == maps.models[0].global_map);
  CHECK(models[0].fault.empty());
  CHECK_FALSE(models[1].global_map);
  CHECK(models[1].fault.find("found no number in pose") != std::string::npos);
}

TEST_CASE("a log without a place is refused", "[mapping][slow]") {
  const Folder folder;
  CHECK_THROWS_AS(map_log(folder.file("none.log")), InputError);
}
