#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <numbers>

#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "core/error.hpp"
#include "io/json/summary_json.hpp"
#include "io/log/relations_file.hpp"
#include "io/log/trajectory_file.hpp"
#include "metric/evaluation.hpp"

namespace asterism {
namespace {

struct EvaluateCommand {
  std::string trajectory;
  std::optional<std::string> relations;  ///< this or the reference
  std::optional<std::string> reference;
  bool json = false;
};

constexpr double degrees = 180 / std::numbers::pi;

/// The least and the greatest stamp, so that a person sees why nothing matches.
std::string stamps_of(const Trajectory& trajectory) {
  const auto [first, last] = std::ranges::minmax_element(trajectory, {}, &TimedPose::stamp_s);
  return fmt::format("{:.6f} to {:.6f} s", first->stamp_s, last->stamp_s);
}

void print_relation_errors(const EvaluateCommand& command, const Trajectory& trajectory) {
  const auto relations = read_relations_file(*command.relations);
  const auto errors = relation_errors(trajectory, relations);
  if (!errors)
    throw InputError(*command.relations, "no relation between two of the trajectory's stamps",
                     "stamps within " + stamps_of(trajectory));
  const auto& [matched, metres, radians] = *errors;
  if (command.json) {
    fmt::print("{}", relation_errors_json(relations.size(), matched,
                                          {metres.mean, metres.standard_deviation},
                                          {radians.mean, radians.standard_deviation}));
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
    fmt::print("{}", reference_errors_json(reference.size(), matched, position_rmse_m,
                                           heading_rmse_rad, fit));
    return;
  }
  fmt::print("{} of {} poses of the reference matched\n", matched, reference.size());
  fmt::print("position error: {:.3f} m RMSE, after the rigid fit\n", position_rmse_m);
  fmt::print("heading error:  {:.2f} degrees RMSE\n", degrees * heading_rmse_rad);
}

int run(const EvaluateCommand& command) {
  const Trajectory trajectory = read_trajectory_file(command.trajectory);
  if (command.relations)
    print_relation_errors(command, trajectory);
  else
    print_reference_errors(command, trajectory);
  return exit_consistent;
}

void add_options(CLI::App& evaluate, EvaluateCommand& command) {
  evaluate.add_option("trajectory", command.trajectory, "TUM file, plain or packed by gzip or xz")
      ->required();
  CLI::Option_group& known = *evaluate.add_option_group("Known", "One of these");
  known.add_option("--relations", command.relations, "Lines of t1 t2 x y z roll pitch yaw")
      ->type_name("FILE");
  known
      .add_option("--reference", command.reference,
                  "TUM file, or lines of scan_index timestamp x y theta kind; of these kind K")
      ->type_name("FILE");
  known.require_option(1);
  evaluate.add_flag("--json", command.json, "Print the errors as JSON, in metres and radians");
}

}  // namespace

void add_evaluate(CLI::App& app, Run& chosen) {
  add_command(app, chosen, "evaluate", "Measure the errors of a trajectory against what is known",
              add_options, run, R"(Examples:
  asterism evaluate out/trajectory.tum --relations intel.relations.xz
  asterism evaluate out/trajectory.tum --reference aces.gmapping.txt.xz --json
Poses match by stamp, to the microsecond; where stamps repeat, the first pose of a file counts.
Relations: mean and standard deviation of what the surveyed motion differs by from the estimated.
Reference: root mean square after the rigid fit of the positions.
Exit code: 0 there is a result, 64 usage, 65 bad input or no stamp in common.)");
}

}  // namespace asterism
