#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "cli/command.hpp"
#include "cli/commands/simulate.hpp"
#include "cli/exit_code.hpp"
#include "cli/option_checks.hpp"
#include "core/error.hpp"
#include "io/json/maps_file.hpp"
#include "io/json/trace_file.hpp"
#include "simulation/corridor_world.hpp"
#include "simulation/grid_world.hpp"

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

int run(const SimulateCommand& command) {
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

const CLI::Validator share = number_between(0, 1, "a number from 0 to 1");

void add_simulated_drive(CLI::App& simulate, SimulateCommand& command) {
  CLI::Option& building = *simulate
                               .add_option("--building", command.building,
                                           "Drive through a building and write the log of its "
                                           "laser, not a trace")
                               ->check(CLI::IsMember({"aces-like", "office"}));
  for (const char* option : {"--world", "--missing", "--stubs", "--corridors"})
    building.excludes(simulate.get_option(option));
  const auto of_building = [&](CLI::Option* option) { option->needs(&building); };
  of_building(simulate.add_option("--turned", command.turned_deg, "Turn the building")
                  ->type_name("DEGREES")
                  ->check(number_between(-360, 360, "degrees from -360 to 360"))
                  ->capture_default_str());
  of_building(simulate.add_flag("--mirrored", command.mirrored, "Mirror the building first"));
  of_building(simulate.add_option("--people", command.people, "People who walk about")
                  ->check(CLI::Range(0, 100))
                  ->capture_default_str());
  of_building(simulate.add_option("--true-trace", command.true_trace,
                                  "Write what a perfect observer would make of the log"));
  of_building(simulate.add_option("--true-trajectory", command.true_trajectory,
                                  "Write where the robot truly was at each scan, in TUM format"));
  of_building(simulate.add_option("--svg", command.svg, "Draw the building and the drive"));
}

void add_options(CLI::App& simulate, SimulateCommand& command) {
  simulate.add_option("--world", command.world, "Kind of world")
      ->check(CLI::IsMember({"grid", "corridors"}))
      ->capture_default_str();
  simulate.add_option("--seed", command.seed, "Seed of world and walk")
      ->check(whole_number)
      ->capture_default_str();
  simulate
      .add_option("--travels", command.travels,
                  "Travels to make [20; aces-like: the 14 of the log]")
      ->check(whole_number);
  simulate.add_option("--width", command.width, "Points of a grid from west to east [4]")
      ->check(CLI::Range(1, 1000));
  simulate
      .add_option("--height", command.height,
                  "Points of a grid from north to south [4; of an office 3]")
      ->check(CLI::Range(1, 1000));
  simulate.add_option("--missing", command.missing, "Share of a grid's corridors that are missing")
      ->check(share)
      ->capture_default_str();
  simulate.add_option("--stubs", command.stubs, "Share of those that are blind stubs")
      ->check(share)
      ->capture_default_str();
  simulate.add_option("--corridors", command.corridors, "Corridors of a corridor world")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  simulate.add_flag("--laps", command.laps, "Walk round a face instead of exploring");
  simulate.add_flag("--plain", command.plain, "Read every star from the world's first arm");
  simulate.add_option("-o,--output", command.output, "Trace file, or log; -: stdout")
      ->capture_default_str();
  simulate.add_option("--true-map", command.true_map, "Write the true map as a maps file");
  add_simulated_drive(simulate, command);
}

}  // namespace

void write_true_map(const std::string& file, const Walk& walk) {
  write_maps_file(file, report_of(walk));
}

void add_simulate(CLI::App& app, Run& chosen) {
  add_command(app, chosen, "simulate",
              "Walk through a random world and write the trace, or drive and write the log",
              add_options, run, R"(Examples:
  asterism simulate --seed 7 -o walk.trace.json
  asterism simulate --world corridors --corridors 9 --travels 40 --seed 1 -o walk.trace.json
  asterism simulate --seed 7 | asterism map /dev/stdin --planar
  asterism simulate --building aces-like --seed 1 -o drive.log --true-trace drive.trace.json
  asterism simulate --building office --seed 5 --turned 30 -o drive.log --svg drive.svg
  asterism simulate --building office -o drive.log --true-trajectory drive.tum
Same options, same bytes.)");
}

}  // namespace asterism
