#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>
#include <numbers>

#include "cli/map_options.hpp"
#include "cli/option_checks.hpp"
#include "cli/options.hpp"
#include "cli/reasoning_options.hpp"
#include "core/error.hpp"
#include "engine/map_tree.hpp"
#include "engine/query_reader.hpp"
#include "engine/ssh_engines.hpp"
#include "io/trace_file.hpp"

namespace {

using namespace asterism;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

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

void add_simulate(CLI::App& app, SimulateCommand& command, std::function<int()>& chosen) {
  CLI::App& simulate = *app.add_subcommand(
      "simulate", "Walk through a random world and write the trace, or drive and write the log");
  simulate.footer(R"(Examples:
  asterism simulate --seed 7 -o walk.trace.json
  asterism simulate --world corridors --corridors 9 --travels 40 --seed 1 -o walk.trace.json
  asterism simulate --seed 7 | asterism map /dev/stdin --planar
  asterism simulate --building aces-like --seed 1 -o drive.log --true-trace drive.trace.json
  asterism simulate --building office --seed 5 --turned 30 -o drive.log --svg drive.svg
  asterism simulate --building office -o drive.log --true-trajectory drive.tum
Same options, same bytes.)");
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
  simulate.callback([&] { chosen = [&] { return simulate_command(command); }; });
}

void add_log(CLI::App& command, std::string& log, LogOptions& laser) {
  command.add_option("log", log, "CARMEN log, plain or packed by gzip or xz")->required();
  command
      .add_option_function<double>(
          "--fov", [&](double degrees) { laser.field_of_view_rad = radians(degrees); },
          "Field of view of the laser, degrees")
      ->type_name("DEG")
      ->check(number_between(0.1, 360, "degrees, 0.1 to 360"));
  command.add_option("--max-range", laser.max_range_m, "A range of this or more is no return")
      ->type_name("M")
      ->check(number_between(0.1, 1e4, "metres, 0.1 to 10000"));
  command
      .add_option_function<std::vector<double>>(
          "--laser-offset",
          [&](const std::vector<double>& at) {
            laser.robot_from_laser = {at[0], at[1], wrapped(radians(at[2]))};
          },
          "Where the laser stands on the robot: metres ahead, metres left, degrees")
      ->type_name("X,Y,DEG")
      ->delimiter(',')
      ->expected(3);
}

void add_gateway_width(CLI::App& command, ScanDetectorOptions& detector) {
  command
      .add_option("--min-gateway-width-m,--min-gateway-width",
                  detector.topology.skeleton.min_gateway_width_m,
                  "Openings of less measured clearance lead nowhere")
      ->type_name("M")
      ->check(number_between(0.1, 10, "metres, 0.1 to 10"))
      ->capture_default_str();
}

void add_perceive(CLI::App& app, PerceiveCommand& command, std::function<int()>& chosen) {
  CLI::App& perceive = *app.add_subcommand("perceive", "Turn a laser log into a trace");
  perceive.footer(R"(Examples:
  asterism perceive drive.log.xz -o drive.trace.json --plots drive-plots
  asterism perceive drive.log --max-range 8.18 --fov 180 -o drive.trace.json
  asterism perceive drive.log --detector-command 'python3 places.py' -o drive.trace.json
  asterism perceive drive.log | asterism map /dev/stdin --planar
With -o FILE.trace.json the maps of the places go to the folder FILE.lpm beside it.
Exit code: 0 there is a trace, 64 usage, 65 bad input or no place in it, 69 a detector that cannot
go on, 70 internal fault or a result that cannot be written.)");
  add_log(perceive, command.log, command.laser);
  perceive.add_option("-o,--output", command.output, "Trace file; -: stdout")
      ->type_name("FILE")
      ->capture_default_str();
  CLI::Option& plots =
      *perceive
           .add_option("--plots", command.plots_folder,
                       "Draw each place as it was seen, a strip of all, and the robot's way")
           ->type_name("DIR");
  CLI::Option& library =
      *perceive
           .add_option("--detector", command.plugin,
                       "Shared library of a place detector; see docs/detectors.md")
           ->type_name("LIB");
  CLI::Option& program =
      *perceive
           .add_option("--detector-command", command.program,
                       "Program that reads scans and writes visits, as lines of JSON")
           ->type_name("CMD");
  library.excludes(&program);
  plots.excludes(&library)->excludes(&program);
  perceive
      .add_option_function<double>(
          "--heading",
          [&](double degrees) { command.detector.start_heading_rad = radians(degrees); },
          "Heading of the robot at the first scan, degrees from the map's x-axis [0]")
      ->type_name("DEG")
      ->check(number_between(-360, 360, "degrees, -360 to 360"))
      ->excludes(&library)
      ->excludes(&program);
  add_gateway_width(perceive, command.detector);
  perceive
      .add_option("--resolution", command.detector.lpm.resolution_m, "Side of a cell of the map")
      ->type_name("M")
      ->check(number_between(0.02, 0.5, "metres, 0.02 to 0.5"))
      ->capture_default_str();
  perceive.add_option("--cells", command.detector.lpm.cells, "Cells along each side of the map")
      ->type_name("N")
      ->check(CLI::Range(60, 2000))
      ->capture_default_str();
  perceive.callback([&] { chosen = [&] { return perceive_command(command); }; });
}

void add_run(CLI::App& app, RunCommand& command, std::function<int()>& chosen) {
  CLI::App& run = *app.add_subcommand("run", "Map a building from a laser log, all the way");
  run.footer(R"(Examples:
  asterism run drive.log.xz -o drive
  asterism run drive.log -o drive --planar --models 10
  asterism run drive.log -o drive --max-range 8.18 --min-gateway-width-m 0.9 --json
Perceives the trace, grows every map that explains it, ranks them by preference and layout, and
draws the best: DIR/report.html shows it all; DIR/log.trace.json, maps.json; of the best model
trajectory.tum, map.pgm, map.yaml, map.png, layout.g2o, map.graphml, map.dot, routes.geojson, of the
others the same in model-2, model-3 ... What an earlier run left there is replaced.
Exit code: 0 a map explains the trace, 1 none does and the best of the longest part that one explains
is drawn, 2 a limit ended the run, 64 usage, 65 bad input or no place in it, 70 internal fault or a
result that cannot be written.)");
  add_log(run, command.log, command.laser);
  run.add_option("-o,--output", command.folder, "Folder for the results")
      ->type_name("DIR")
      ->required();
  run.add_flag("--planar", command.maps.planar, "Keep the maps that can be drawn in the plane");
  add_assumptions(run, command.assume);
  run.add_option("--models", command.models, "Maps to rank and draw")
      ->type_name("N")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  run.add_option_function<std::string>(
         "--rank", [&](const std::string& which) { command.only_minimal = which == "minimal"; },
         "Rank all maps, or the minimal models alone: these are searched for, and the others not "
         "counted, unless --max-hypotheses has them all listed [all]")
      ->check(CLI::IsMember({"all", "minimal"}));
  add_gateway_width(run, command.detector);
  run.add_option("--resolution", command.resolution_m, "Side of a cell of the global map")
      ->type_name("M")
      ->check(number_between(0.01, 1, "metres, 0.01 to 1"))
      ->capture_default_str();
  run.add_option("--certify", command.maps.certify_s,
                 "Seconds the solver has to prove the minimal maps minimal; 0: off")
      ->type_name("S")
      ->check(number_between(0, 1e6, "seconds, 0 or more"))
      ->capture_default_str();
  command.maps.max_hypotheses = 10'000'000;
  run.add_option("--max-hypotheses", command.maps.max_hypotheses,
                 "Stop growing maps where a visit leaves more")
      ->type_name("N")
      ->check(whole_number)
      ->capture_default_str();
  run.add_option("--time-limit", command.maps.time_limit_s,
                 "Stop growing maps after this many seconds")
      ->type_name("S")
      ->check(seconds);
  run.add_flag("--json", command.json, "Print a summary as JSON");
  run.callback([&] {
    // The default is for listing; what is asked for has the maps listed.
    if (command.only_minimal && run.get_option("--max-hypotheses")->count() == 0)
      command.maps.max_hypotheses.reset();
    chosen = [&] { return run_command(command); };
  });
}

void add_evaluate(CLI::App& app, EvaluateCommand& command, std::function<int()>& chosen) {
  CLI::App& evaluate =
      *app.add_subcommand("evaluate", "Measure the errors of a trajectory against what is known");
  evaluate.footer(R"(Examples:
  asterism evaluate out/trajectory.tum --relations intel.relations.xz
  asterism evaluate out/trajectory.tum --reference aces.gmapping.txt.xz --json
Poses match by stamp, to the microsecond; where stamps repeat, the first pose of a file counts.
Relations: mean and standard deviation of what the surveyed motion differs by from the estimated.
Reference: root mean square after the rigid fit of the positions.
Exit code: 0 there is a result, 64 usage, 65 bad input or no stamp in common.)");
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
  evaluate.callback([&] { chosen = [&] { return evaluate_command(command); }; });
}

void add_axioms(CLI::App& app, AxiomOptions& options, std::function<int()>& chosen) {
  CLI::App& axioms = *app.add_subcommand("axioms", "Print the axioms in force");
  axioms.footer(R"(Examples:
  asterism axioms
  asterism axioms --axiom one_crossing
  asterism axioms --axioms my-axioms)");
  add_axiom_options(axioms, options);
  axioms.callback([&] { chosen = [&] { return axioms_command(options); }; });
}

void add_validate(CLI::App& app, std::vector<std::string>& files, std::function<int()>& chosen) {
  CLI::App& validate = *app.add_subcommand("validate", "Check files and say what is wrong");
  validate.footer(R"(Examples:
  asterism validate drive.trace.json drive.maps.json
  asterism validate drive.log.xz
  asterism validate my-axioms
  asterism validate out/trajectory.tum out/map.yaml out/layout.g2o
Of these endings, all but *.json and *.yaml maybe with .gz or .xz: *.maps.json is a maps file,
*.checkpoint.json where a search stands, *.expect.json what a trace is expected to give, *.log and *.clf a CARMEN log of laser scans, *.tum a trajectory, *.gmapping.txt a reference,
*.relations surveyed relations, *.g2o a pose graph, *.pgm a picture, *.yaml an occupancy map with
its picture. A folder holds axioms, anything else is a trace.)");
  validate.add_option("files", files, "Traces, maps, logs and others, folders of axioms")
      ->required();
  validate.callback([&] { chosen = [&] { return validate_command(files); }; });
}

int fail(int code, const std::string& message) {
  std::fprintf(stderr, "asterism: %s\n", message.c_str());
  return code;
}

int run(int argc, char** argv) {
  CLI::App app("Every topological map that a robot's trace allows, and the simplest");
  app.name("asterism");
  app.require_subcommand(1);
  app.set_version_flag("--version", std::function<std::string()>(version_text),
                       "Versions of asterism and its libraries");
  app.footer("Each command has a --help with examples.");

  MapCommand map;
  QueryCommand query;
  ExplainCommand explain;
  VerifyCommand verify;
  NextCommand next;
  TestCommand test;
  PerceiveCommand perceive;
  RunCommand whole;
  SimulateCommand simulate;
  EvaluateCommand evaluate;
  AxiomOptions axioms;
  std::vector<std::string> files;
  std::function<int()> chosen;
  add_map(app, map, chosen);
  add_query(app, query, chosen);
  add_explain(app, explain, chosen);
  add_verify(app, verify, chosen);
  add_next(app, next, chosen);
  add_test(app, test, chosen);
  add_perceive(app, perceive, chosen);
  add_run(app, whole, chosen);
  add_simulate(app, simulate, chosen);
  add_evaluate(app, evaluate, chosen);
  add_axioms(app, axioms, chosen);
  add_validate(app, files, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    return fail(exit_usage, error.what() + std::string("; see --help"));
  }
  const int code = chosen();
  if (std::cout.flush().fail() || std::fflush(stdout) != 0)
    return fail(exit_internal, "stdout: found a failure to write; expected the result there");
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const QueryError& error) {
    const int code = fail(exit_usage, error.what());
    std::fprintf(stderr, "%s\n", error.excerpt().c_str());
    return code;
  } catch (const InputError& error) {
    return fail(exit_bad_input, error.what());
  } catch (const PluginError& error) {
    return fail(exit_plugin, error.what());
  } catch (const DifferenceError& error) {
    const int code = fail(exit_internal, error.what());
    std::fputs(trace_json(error.shortest_trace).c_str(), stderr);
    return code;
  } catch (const SshDifferenceError& error) {
    const int code = fail(exit_internal, error.what());
    std::fputs(trace_json(error.shortest_experience).c_str(), stderr);
    return code;
  } catch (const std::exception& error) {
    return fail(exit_internal, error.what());
  }
}
