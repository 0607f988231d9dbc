#include <fmt/format.h>

#include <iostream>
#include <stdexcept>

#include "cli/commands/simulate.hpp"
#include "cli/exit_code.hpp"
#include "cli/text/building_svg.hpp"
#include "core/angle.hpp"
#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/json/trace_file.hpp"
#include "io/log/carmen_log.hpp"
#include "io/log/trajectory_file.hpp"
#include "simulation/drive.hpp"
#include "simulation/office_building.hpp"
#include "simulation/ring_building.hpp"

namespace asterism {
namespace {

Building make_building(const SimulateCommand& command, RandomEngine& engine) {
  Building building = [&] {
    if (*command.building == "aces-like") return ring_building(engine);
    try {
      return office_building(
          {.columns = command.width.value_or(4), .rows = command.height.value_or(3)}, engine);
    } catch (const std::invalid_argument& error) {
      throw InputError("simulate: " + std::string(error.what()));
    }
  }();
  if (command.mirrored) building = mirrored(building);
  const double turned_rad = radians(command.turned_deg);
  if (turned_rad != 0) building = moved(std::move(building), {0, 0, turned_rad});
  return building;
}

Route make_route(const SimulateCommand& command, const World& world, RandomEngine& engine) {
  if (*command.building == "aces-like" && !command.travels && !command.laps)
    return ring_route(world);
  return random_route(world,
                      {.travels = command.travels.value_or(default_travels),
                       .policy = command.laps ? Policy::laps : Policy::explore},
                      engine);
}

}  // namespace

int simulate_drive(const SimulateCommand& command) {
  RandomEngine engine(command.seed);
  const Building building = make_building(command, engine);
  const Route route = make_route(command, building.world, engine);
  Drive drive(building, route, {.people = command.people, .disguised = !command.plain}, engine());
  std::vector<Pose2> told;
  Trajectory world_from_robot;
  const ScanSource next = [&] {
    auto scan = drive.next();
    if (scan && command.svg) told.push_back(scan->odom_from_robot);
    if (scan && command.true_trajectory) {
      world_from_robot.push_back(
          {scan->stamp_s, drive.world_from_robot()[static_cast<std::size_t>(scan->number)]});
    }
    return scan;
  };
  if (command.output == "-")
    write_carmen_log(std::cout, next);
  else
    write_carmen_log(command.output, next);
  Walk truth = drive.truth();
  truth.trace.name = fmt::format("{}-seed-{}", building.name, command.seed);
  if (command.true_trace) write_trace_file(*command.true_trace, truth.trace);
  if (command.true_trajectory) write_trajectory_file(*command.true_trajectory, world_from_robot);
  if (command.true_map) write_true_map(*command.true_map, truth);
  if (command.svg)
    write_atomically(*command.svg, building_svg(building, drive.world_from_robot(), told));
  return exit_consistent;
}

}  // namespace asterism
