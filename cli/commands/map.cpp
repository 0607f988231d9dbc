#include "cli/commands/map.hpp"

#include <CLI/CLI.hpp>
#include <utility>
#include <variant>

#include "cli/command.hpp"
#include "cli/option_checks.hpp"
#include "core/error.hpp"
#include "io/json/trace_file.hpp"

namespace asterism {
namespace {

int run(MapCommand command) {
  const auto stated = read_assumptions(command.maps.assume);
  const AnyTrace any = read_any_trace_file(file_of(command.maps));
  if (const auto* experience = std::get_if<Experience>(&any))
    return map_experience(command, *experience);
  const Trace& trace = std::get<Trace>(any);
  const Theory theory = read_theory(command, assumptions_of(stated, trace));
  if (!command.why_not.empty()) return why_not(command, theory, trace);
  if (command.maps.options.method == "search") return map_minimal(command, theory, trace);
  return map_trace(command, theory, trace);
}

/// The search for the minimal models alone, and what can be asked of it.
void add_minimal(CLI::App& map, MapCommand& command) {
  CLI::Option& minimal = *map.add_flag("--minimal", command.maps.only_minimal,
                                       "Search for the minimal models and prove them, without "
                                       "listing all maps; lists them after all "
                                       "for a trace of the basic SSH, with --check and with axioms "
                                       "that the search does not know, and "
                                       "says so");
  for (const char* option : {"--all", "--max-hypotheses", "--why-not"})
    minimal.excludes(map.get_option(option));
  add_jobs(map, command.maps.jobs).needs(&minimal);
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

void add_options(CLI::App& map, MapCommand& command) {
  MapOptions& options = command.maps.options;
  add_maps_of_trace(map, command.maps);
  add_check(map, options);
  add_assumptions(map, command.maps.assume);
  CLI::Option& certify =
      *map.add_option("--certify", options.certify_s,
                      "Seconds the solver may take to certify the minimal models; 0: do not, as "
                      "with --minimal unless given")
           ->type_name("S")
           ->check(seconds)
           ->capture_default_str();
  map.add_option("--json", command.maps.json, "Write a maps file; -: alone on stdout")
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
  map.parse_complete_callback([&] {
    if (command.maps.only_minimal && certify.count() == 0) options.certify_s = 0;
  });
}

}  // namespace

Theory read_theory(MapCommand& command, std::vector<Assumption> assumptions) {
  Theory theory = read_theory(command.maps, std::move(assumptions));
  MapOptions& options = command.maps.options;
  if (command.maps.only_minimal) {
    // The search knows the shipped axioms, as the native engine does.
    if (!theory.axioms.is_shipped() && options.check == "native") options.check = "solver";
    options.method = options.check == "native" ? "search" : "listing";
  }
  require_decidable(theory, options);
  return theory;
}

void require_no_checkpoint(const MapCommand& command, const std::string& found,
                           const std::string& expected) {
  if (command.checkpoint)
    throw InputError("--checkpoint", found, expected + ", since maps listed have none");
}

void add_map(CLI::App& app, Run& chosen) {
  add_command(app, chosen, "map", "Find every map that explains a trace", add_options, run,
              R"(Examples:
  asterism map examples/aces-stubs.trace.json --planar
  asterism map drive.trace.json --svg drawings --json drive.maps.json
  asterism map drive.trace.json --all --json - | jq .consistent
  asterism map drive.trace.json --minimal --jobs 2 --checkpoint drive.checkpoint.json --resume
  asterism map drive.trace.json --minimal --time-limit 60 --memory-limit 2G
  asterism map drive.trace.json --why-not 0,1,2,0
  asterism map drive.trace.json --assume 'same(0,8)' --assume 'differ(2,5)'
  asterism map examples/05_square.trace.json
The last is a trace of the basic SSH, views and actions in turn: see docs/ssh.md.
Exit code: 0 a map exists, 1 none does (with --why-not: refuted), 2 stopped by a limit or Ctrl-C (with
--why-not: undecided in 60 s), 64 usage, 65 bad input, 70 internal fault or a result that cannot be
written.)");
}

}  // namespace asterism
