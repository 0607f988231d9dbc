#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "cli/options.hpp"
#include "core/error.hpp"
#include "io/relations_file.hpp"
#include "io/trajectory_file.hpp"
#include "metric/evaluation.hpp"

namespace asterism {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

/// The least and the greatest stamp, so that a person sees why nothing matches.
std::string stamps_of(const Trajectory& trajectory) {
  const auto [first, last] = std::ranges::minmax_element(trajectory, {}, &TimedPose::stamp_s);
  return fmt::format("{:.6f} to {:.6f} s", first->stamp_s, last->stamp_s);
}

std::string json_of(const Spread& spread) {
  return fmt::format("{{ \"mean\": {}, \"standard_deviation\": {} }}", spread.mean,
                     spread.standard_deviation);
}

void print_relation_errors(const EvaluateCommand& command, const Trajectory& trajectory) {
  const auto relations = read_relations_file(*command.relations);
  const auto errors = relation_errors(trajectory, relations);
  if (!errors)
    throw InputError(*command.relations, "no relation between two of the trajectory's stamps",
                     "stamps within " + stamps_of(trajectory));
  const auto& [matched, metres, radians] = *errors;
  if (command.json) {
    fmt::print(
        "{{ \"relations\": {}, \"matched\": {},\n  \"translation_m\": {},\n"
        "  \"rotation_rad\": {} }}\n",
        relations.size(), matched, json_of(metres), json_of(radians));
    return;
  }
  fmt::print("{} of {} relations matched\n", matched, relations.size());
  fmt::print("translation error: {:.3f} ± {:.3f} m\n", metres.mean, metres.standard_deviation);
  fmt::print("rotation error:    {:.2f} ± {:.2f} degrees\n", degrees * radians.mean,
             degrees * radians.standard_deviation);
}

void print_reference_errors(const EvaluateCommand& command, const Trajectory& trajectory) {
  const Trajectory reference = read_reference_file(*command.reference);
  const auto errors = reference_errors(trajectory, reference);
  if (!errors)
    throw InputError(*command.reference, "no stamp of the trajectory's",
                     "stamps within " + stamps_of(trajectory));
  const auto& [matched, position_rmse_m, heading_rmse_rad, fit] = *errors;
  if (command.json) {
    fmt::print(
        "{{ \"poses\": {}, \"matched\": {},\n  \"position_rmse_m\": {}, \"heading_rmse_rad\": {},\n"
        "  \"reference_from_layout\": [{}, {}, {}] }}\n",
        reference.size(), matched, position_rmse_m, heading_rmse_rad, fit.x_m, fit.y_m,
        fit.heading_rad);
    return;
  }
  fmt::print("{} of {} poses of the reference matched\n", matched, reference.size());
  fmt::print("position error: {:.3f} m RMSE, after the rigid fit\n", position_rmse_m);
  fmt::print("heading error:  {:.2f} degrees RMSE\n", degrees * heading_rmse_rad);
}

}  // namespace

int evaluate_command(const EvaluateCommand& command) {
  const Trajectory trajectory = read_trajectory_file(command.trajectory);
  if (command.relations)
    print_relation_errors(command, trajectory);
  else
    print_reference_errors(command, trajectory);
  return exit_consistent;
}

}  // namespace asterism
