#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>

#include "axioms/axiom_set.hpp"
#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/text/map_text.hpp"
#include "core/error.hpp"
#include "io/grid/occupancy_map.hpp"
#include "io/grid/pgm_image.hpp"
#include "io/json/checkpoint_file.hpp"
#include "io/json/maps_file.hpp"
#include "io/json/perception_file.hpp"
#include "io/json/trace_file.hpp"
#include "io/log/carmen_log.hpp"
#include "io/log/pose_graph_file.hpp"
#include "io/log/relations_file.hpp"
#include "io/log/trajectory_file.hpp"
#include "mapping/expected_answers.hpp"

namespace asterism {
namespace {

/// Whether a file's name ends so, or so and as of a packed file.
bool is_named(const std::string& file, const std::string& ending) {
  return std::ranges::any_of(std::array{"", ".gz", ".xz"},
                             [&](const char* packed) { return file.ends_with(ending + packed); });
}

/// Reads a log whole; tells what a drive it is.
std::string log_text(const std::string& file) {
  LogReader reader(file);
  std::optional<Scan> scan = reader.next();
  const std::size_t beams = scan->ranges_m.size();  // a log without a scan is refused
  double first_s = scan->stamp_s, last_s = scan->stamp_s, length_m = 0;
  long long scans = 0;
  for (Point2 before = scan->odom_from_robot.position(); scan; scan = reader.next()) {
    const Point2 at = scan->odom_from_robot.position();
    length_m += norm(at - before);
    before = at;
    first_s = std::min(first_s, scan->stamp_s);
    last_s = std::max(last_s, scan->stamp_s);
    ++scans;
  }
  return fmt::format("log: {} scans of {} beams, {:.1f} s, {:.1f} m", scans, beams,
                     last_s - first_s, length_m);
}

std::string trajectory_text(const Trajectory& trajectory, const char* kind) {
  double length_m = 0;
  for (std::size_t i = 1; i < trajectory.size(); ++i)
    length_m += norm(trajectory[i].layout_from_robot.position() -
                     trajectory[i - 1].layout_from_robot.position());
  return fmt::format("{}: {} poses, {:.1f} m", kind, trajectory.size(), length_m);
}

std::string pose_graph_text(const PoseGraph& graph) {
  return fmt::format("pose graph: {} places, {} displacements, {} fixed",
                     graph.layout_from_place.size(), graph.displacements.size(),
                     graph.fixed.size());
}

std::string picture_text(const GreyImage& image) {
  return fmt::format("picture: {} x {} pixels", image.width, image.height);
}

std::string occupancy_map_text(const Grid& grid) {
  return fmt::format("occupancy map: {} x {} cells of {} m", grid.width, grid.height,
                     grid.resolution_m);
}

std::string maps_text(const MapReport& report) {
  const std::string ranked =
      report.ranked.empty() ? "" : fmt::format(", {} ranked", report.ranked.size());
  return fmt::format("maps of {}: {} listed{}", printable(report.trace), report.maps.size(),
                     ranked);
}

std::string maps_text(const SshReport& report) {
  return fmt::format("maps of {}, basic SSH: {} listed", printable(report.trace),
                     report.maps.size());
}

std::string trace_text(const Trace& trace) {
  return fmt::format("trace {}: {} visits", printable(trace.name), trace.visits.size());
}

std::string trace_text(const Experience& experience) {
  return fmt::format("trace {}, basic SSH: {} views", printable(experience.name),
                     experience.views.size());
}

std::string checkpoint_text(const Checkpoint& checkpoint) {
  return fmt::format("checkpoint of {}: {} maps, {} branches", printable(checkpoint.search.trace),
                     checkpoint.state.models.size(), checkpoint.state.branches.size());
}

std::string perception_text(const PerceptionRecord& record) {
  return fmt::format("kept perception: {} scans, by {}", record.map_from_robot.size(),
                     printable(record.perceived_by));
}

/// Reads a file of whatever kind its name says; tells what it is.
std::string validated(const std::string& file) {
  if (file.ends_with("maps.json"))
    return std::visit([](const auto& report) { return maps_text(report); },
                      read_any_maps_file(file));
  if (file.ends_with("checkpoint.json")) return checkpoint_text(read_checkpoint_file(file));
  if (file.ends_with("perception.json")) return perception_text(read_perception_file(file));
  if (file.ends_with("expect.json")) {
    const Expectation expectation = read_expected_answers(file);
    return fmt::format("what to expect: {}", size_text(expectation));
  }
  if (is_named(file, ".log") || is_named(file, ".clf")) return log_text(file);
  if (is_named(file, ".tum")) return trajectory_text(read_trajectory_file(file), "trajectory");
  if (is_named(file, ".gmapping.txt"))
    return trajectory_text(read_reference_file(file), "reference");
  if (is_named(file, ".relations"))
    return fmt::format("relations: {}", read_relations_file(file).size());
  if (is_named(file, ".g2o")) return pose_graph_text(read_pose_graph_file(file));
  if (is_named(file, ".pgm")) return picture_text(read_pgm_file(file));
  if (file.ends_with(".yaml")) return occupancy_map_text(read_occupancy_map_file(file));
  if (std::filesystem::is_directory(file)) {
    const AxiomSet axioms = AxiomSet::read(file);
    return fmt::format("a folder of {} axioms", axioms.axioms().size());
  }
  return std::visit([](const auto& trace) { return trace_text(trace); }, read_any_trace_file(file));
}

int run(const std::vector<std::string>& files) {
  int result = exit_consistent;
  for (const std::string& file : files) {
    try {
      fmt::print("{}: valid, {}\n", file, validated(file));
    } catch (const InputError& error) {
      fmt::print(stderr, "{}\n", error.what());
      result = exit_bad_input;
    }
  }
  return result;
}

void add_options(CLI::App& validate, std::vector<std::string>& asked) {
  validate.add_option("files", asked, "Traces, maps, logs and others, folders of axioms")
      ->required();
}

}  // namespace

void add_validate(CLI::App& app, Run& chosen) {
  add_command(app, chosen, "validate", "Check files and say what is wrong", add_options, run,
              R"(Examples:
  asterism validate drive.trace.json drive.maps.json
  asterism validate drive.log.xz
  asterism validate my-axioms
  asterism validate out/trajectory.tum out/map.yaml out/layout.g2o
Of these endings, all but *.json and *.yaml maybe with .gz or .xz: *.maps.json is a maps file,
*.checkpoint.json where a search stands, *perception.json what a run keeps of its perception,
*.expect.json what a trace is expected to give, *.log and *.clf a CARMEN log of laser scans, *.tum a
trajectory, *.gmapping.txt a reference, *.relations surveyed relations, *.g2o a pose graph, *.pgm a
picture, *.yaml an occupancy map with its picture. A folder holds axioms, anything else is a
trace.)");
}

}  // namespace asterism
