#include <fmt/format.h>

#include <cstdio>

#include "cli/options.hpp"
#include "cli/true_map.hpp"
#include "core/error.hpp"
#include "io/maps_file.hpp"
#include "io/trace_file.hpp"
#include "simulation/corridor_world.hpp"
#include "simulation/grid_world.hpp"
#include "simulation/walk.hpp"

namespace asterism {
namespace {

World make_world(const SimulateCommand& command, RandomEngine& engine) {
  if (command.world == "corridors") return corridor_world({.corridors = command.corridors}, engine);
  return grid_world({.width = command.width.value_or(4),
                     .height = command.height.value_or(4),
                     .missing = command.missing,
                     .stubs = command.stubs},
                    engine);
}

/// The truth as a maps file of one map.
MapReport report_of(const Walk& walk) {
  MapReport report;
  report.trace = walk.trace.name;
  report.maps.push_back(make_map(walk.trace, walk.truth));
  report.minimal = {.paths = report.maps.front().paths.size(),
                    .places = report.maps.front().places.size(),
                    .count = 1,
                    .certified = false};
  return report;
}

}  // namespace

void write_true_map(const std::string& file, const Walk& walk) {
  write_maps_file(file, report_of(walk));
}

int simulate_command(const SimulateCommand& command) {
  if (command.true_map == "-") throw InputError("--true-map", "-", "a file, since stdout is taken");
  if (command.building) return simulate_drive(command);
  RandomEngine engine(command.seed);
  Walk walked = [&] {
    try {
      const World world = make_world(command, engine);
      return walk(world,
                  {.travels = command.travels.value_or(default_travels),
                   .policy = command.laps ? Policy::laps : Policy::explore,
                   .disguised = !command.plain},
                  engine);
    } catch (const std::invalid_argument& error) {
      throw InputError("simulate: " + std::string(error.what()));
    }
  }();
  walked.trace.name = fmt::format("{}-seed-{}", command.world, command.seed);
  if (command.output == "-")
    fmt::print("{}", trace_json(walked.trace));
  else
    write_trace_file(command.output, walked.trace);
  if (command.true_map) write_true_map(*command.true_map, walked);
  return exit_consistent;
}

}  // namespace asterism
