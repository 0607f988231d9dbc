#include "cli/map_options.hpp"

#include <CLI/CLI.hpp>

#include "cli/option_checks.hpp"

namespace asterism {
void add_maps_of_trace(CLI::App& app, MapCommand& command) {
  app.add_option("trace", command.trace, "Trace file (*.trace.json); -: stdin")->required();
  app.add_flag("--planar", command.options.planar, "Keep only maps that can be drawn in the plane");
  add_axiom_options(app, command.axioms);
}

void add_check(CLI::App& app, MapOptions& options) {
  app.add_option("--check", options.check,
                 "Who decides: native, the solver alone, or both compared at every candidate")
      ->check(CLI::IsMember({"native", "solver", "both"}))
      ->capture_default_str();
}

void add_assumptions(CLI::App& app, std::vector<std::string>& texts) {
  app.add_option("--assume", texts,
                 "Keep only maps where this holds: same(I,J) or differ(I,J), visits I and J being "
                 "to one place or to two (repeatable)")
      ->type_name("FACT")
      ->allow_extra_args(false)  // queries may follow
      ->take_all();
}

void add_limits(CLI::App& app, MapOptions& options) {
  app.add_option("--max-hypotheses", options.max_hypotheses,
                 "Stop when a visit leaves more maps than this")
      ->type_name("N")
      ->check(whole_number);
  app.add_option("--time-limit", options.time_limit_s, "Stop after this many seconds")
      ->type_name("S")
      ->transform(duration);
}

CLI::Option& add_jobs(CLI::App& app, unsigned& jobs) {
  return *app.add_option("--jobs", jobs, "Threads of the search for minimal models")
              ->type_name("N")
              ->check(CLI::Range(1, 1024))
              ->capture_default_str();
}

void add_axiom_options(CLI::App& app, AxiomOptions& options) {
  app.add_option("--axioms", options.folder,
                 "Folder of axioms (*.smt2) instead of the shipped ones")
      ->type_name("DIR");
  app.add_option("--axiom", options.optional,
                 "Switch an optional axiom on; `asterism axioms` names them (repeatable)")
      ->type_name("NAME")
      ->take_all();
}

namespace {

/// The search for the minimal models alone, and what can be asked of it.
void add_minimal(CLI::App& map, MapCommand& command) {
  CLI::Option& minimal = *map.add_flag("--minimal", command.minimal,
                                       "Search for the minimal models and prove them, without "
                                       "listing all maps; lists them after all "
                                       "for a trace of the basic SSH, with --check and with axioms "
                                       "that the search does not know, and "
                                       "says so");
  for (const char* option : {"--all", "--max-hypotheses", "--why-not"})
    minimal.excludes(map.get_option(option));
  add_jobs(map, command.jobs).needs(&minimal);
  CLI::Option& checkpoint =
      *map.add_option("--checkpoint", command.checkpoint,
                      "Keep in a file where the search stands; removed once it is through")
           ->type_name("FILE")
           ->needs(&minimal);
  map.add_option("--checkpoint-every", command.checkpoint_every_s, "Seconds between")
      ->type_name("S")
      ->check(seconds)
      ->capture_default_str()
      ->needs(&checkpoint);
  map.add_flag("--resume", command.resume, "Go on from the checkpoint, if there is one")
      ->needs(&checkpoint);
}

}  // namespace

void add_map(CLI::App& app, MapCommand& command, std::function<int()>& chosen) {
  CLI::App& map = *app.add_subcommand("map", "Find every map that explains a trace");
  map.footer(R"(Examples:
  asterism map examples/aces-stubs.trace.json --planar
  asterism map drive.trace.json --svg drawings --json drive.maps.json
  asterism map drive.trace.json --all --json - | jq .consistent
  asterism map drive.trace.json --minimal --jobs 2 --checkpoint drive.checkpoint.json --resume
  asterism map drive.trace.json --minimal --time-limit 60 --memory-limit 2G
  asterism map drive.trace.json --why-not 0,1,2,0
  asterism map drive.trace.json --assume 'same(0,8)' --assume 'differ(2,5)'
  asterism map examples/05_square.trace.json
The last is a trace of the basic SSH, views and actions in turn: see docs/ssh.md.
Exit code: 0 a map exists, 1 none does (with --why-not: refuted), 2 stopped by a limit or Ctrl-C,
64 usage, 65 bad input, 70 internal fault or a result that cannot be written.)");
  MapOptions& options = command.options;
  add_maps_of_trace(map, command);
  add_check(map, options);
  add_assumptions(map, command.assume);
  CLI::Option& certify =
      *map.add_option("--certify", options.certify_s,
                      "Seconds the solver may take to certify the minimal models; 0: do not, as "
                      "with --minimal unless given")
           ->type_name("S")
           ->check(seconds)
           ->capture_default_str();
  map.add_option("--json", command.json, "Write a maps file; -: alone on stdout")
      ->type_name("FILE");
  map.add_flag("--all", options.all, "List every map, not the minimal models alone");
  map.add_option("--svg", command.svg_folder,
                 "Draw each minimal model, and the number of maps a visit, into a folder")
      ->type_name("DIR");
  map.add_option("--export-smt2", command.smt2_folder,
                 "Write the grounded problem of each map listed, for z3 or cvc5")
      ->type_name("DIR");
  CLI::Option& why_not =
      *map.add_option(
              "--why-not", command.why_not,
              "Say why the last of these visits cannot be at the last of these places: the place "
              "of each visit from the first, a new one having the next number")
           ->type_name("PLACES")
           ->check(whole_number)
           ->delimiter(',');
  add_limits(map, options);
  map.add_option("--memory-limit", options.memory_limit_bytes,
                 "Stop before more memory is held: bytes, or 500K, 200M, 1G")
      ->type_name("SIZE")
      ->transform(memory_size);
  add_minimal(map, command);
  for (const char* option : {"--json", "--all", "--svg", "--max-hypotheses", "--time-limit",
                             "--memory-limit", "--assume"})
    why_not.excludes(map.get_option(option));
  map.callback([&] {
    if (command.minimal && certify.count() == 0) options.certify_s = 0;
    chosen = [&] { return map_command(command); };
  });
}

}  // namespace asterism
