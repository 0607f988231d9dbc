#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <map>

#include "cli/asked_maps.hpp"
#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/progress.hpp"
#include "cli/text/exits_svg.hpp"
#include "core/error.hpp"
#include "engine/ask/exits.hpp"
#include "engine/ask/telling_apart.hpp"
#include "io/atomic_file.hpp"
#include "io/json/exits_json.hpp"
#include "io/json/trace_file.hpp"
#include "mapping/trace_maps.hpp"

namespace asterism {
namespace {

struct NextCommand {
  AskedMaps maps;
  ExitBounds bounds;
  std::optional<std::string> svg;
};

std::string counted(std::uint64_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// "h- 2 0": the arm to leave the last visit by, then arms clockwise of the one come in by.
std::string text_of(const Visit& last, const Turns& turns) {
  std::string text = first_arm(last, turns);
  for (const std::size_t turn : further(turns)) text += fmt::format(" {}", turn);
  return text;
}

void print_exits(const Visit& last, const Exits& found) {
  fmt::print("\n{:<12} {:>12}  {:>8}  {:>8}\n", "exit", "expected", "known", "open");
  for (const Exit& exit : found.exits) {
    fmt::print("{:<12} {:>12.1f}  {:>8}  {:>8}{}\n", text_of(last, exit.turns), exit.expected_left,
               exit.known, exit.open, exit.tells ? "" : "  tells nothing");
    for (const auto& [seen, left, chance] : exit.outlooks)
      fmt::print("  {:>8.0f}% {:>12}  {}\n", 100 * chance, left,
                 seen ? seen->text() : "anything else");
  }
  if (!found.complete) fmt::print("there may be more exits, farther away\n");
}

/// A line for each star that is expected after each travel, with the models that expect it.
void print_expected(const TellingApart& apart) {
  for (std::size_t travel = 0; travel < apart.turns.size(); ++travel) {
    std::map<std::string, std::vector<std::size_t>> models;
    for (std::size_t m = 0; m < apart.expected.size(); ++m)
      if (travel < apart.expected[m].size()) models[apart.expected[m][travel].text()].push_back(m);
    for (const auto& [star, which] : models)
      fmt::print("  after travel {}: {} in {} {}\n", travel + 1, star,
                 which.size() == 1 ? "model" : "models", fmt::join(which, " "));
  }
}

void print_telling_apart(const Visit& last, std::size_t models, const TellingApart& apart) {
  if (models == 1) return fmt::print("\n1 minimal model: nothing to tell apart\n");
  if (apart.answer == TellingApart::Answer::found) {
    fmt::print("\n{} tells the {} minimal models apart\n", text_of(last, apart.turns), models);
    return print_expected(apart);
  }
  fmt::print("\n{}: {}\n", counted(models, "minimal model"),
             apart.answer == TellingApart::Answer::none
                 ? "no row of travels is sure to tell them all apart"
                 : "whether a row of travels is sure to tell them all apart is undecided, too many "
                   "having been tried");
}

void print(const TraceMaps& maps, const ExitsReport& report) {
  if (report.stopped_by) {
    fmt::print("undecided, stopped by {}\n", *report.stopped_by);
    if (!report.only_minimal)
      fmt::print("(--over minimal needs the minimal models alone, not every map)\n");
    return;
  }
  if (!report.exits)
    return fmt::print("no map explains the trace: none is left after visit {}\n",
                      maps.explained_visits());
  const Visit& last = report.last;
  const std::uint64_t size = maps.list().size;
  const std::string noun = std::string(report.options.theory.planar ? "planar " : "") +
                           (report.only_minimal ? "minimal model" : "map");
  fmt::print("{} {} the trace; the robot is where visit {} was, {}\n", counted(size, noun),
             size == 1 ? "explains" : "explain", maps.trace().visits.size() - 1, last.star.text());
  if (report.only_minimal) fmt::print("(counted below are the minimal models alone)\n");
  print_exits(last, *report.exits);
  print_telling_apart(last, maps.minimal().size, report.apart);
}

std::string picture(const TraceMaps& maps, const ExitsReport& report) {
  std::vector<NamedExit> named;
  for (const Exit& exit : report.exits->exits)
    named.push_back({text_of(report.last, exit.turns), exit});
  const std::string title =
      fmt::format("{}: ways on from visit {}{}", report.trace, maps.trace().visits.size() - 1,
                  report.only_minimal            ? ", minimal models"
                  : report.options.theory.planar ? ", planar maps"
                                                 : "");
  return exits_svg(title, named, maps.list().size);
}

/// Looks out from the maps, as far as the limits let it.
void look_out(const ExitBounds& bounds, const TraceMaps& maps, Progress& progress,
              ExitsReport& report) {
  if (maps.list().size == 0) return;
  report.exits = exits(maps.list(), bounds, progress.stop());
  if (report.exits)
    report.apart = tell_apart(maps.minimal(), default_most_numbers, progress.stop());
  if (!report.exits || report.apart.answer == TellingApart::Answer::stopped) {
    report.stopped_by = progress.stop().reason;
    report.exits.reset();
  }
}

/// Finds the maps and looks out from them.
void find_exits(const ExitBounds& bounds, TraceMaps& maps, Progress& progress,
                ExitsReport& report) {
  report.stopped_by = maps.find(progress.stop(maps));
  if (!report.stopped_by) look_out(bounds, maps, progress, report);
  if (report.stopped_by) return;
  report.consistent = maps.consistent();
  report.minimal = maps.minimal().size;
}

int run(NextCommand command) {
  AskedMaps& asked = command.maps;
  const Trace trace = read_trace_file(file_of(asked));
  const Theory theory = read_theory(asked);
  require_decidable(theory, asked.options);
  if (!theory.axioms.is_shipped())
    throw InputError("--axioms", other_than_shipped(theory.axioms),
                     "those, since the native engine counts what may be seen and knows no others");

  Progress progress(trace.visits.size(), asked.options.time_limit_s);
  TraceMaps maps(trace, theory, asked.options, asked.only_minimal, asked.jobs);
  ExitsReport report{.trace = trace.name,
                     .last = trace.visits.back(),
                     .options = asked.options,
                     .max_travels = command.bounds.travels,
                     .only_minimal = asked.only_minimal};
  find_exits(command.bounds, maps, progress, report);

  if (command.svg && report.exits) write_atomically(*command.svg, picture(maps, report));
  if (write_answer(asked, exits_json(report))) print(maps, report);
  if (report.stopped_by) return exit_undecided;
  return report.exits ? exit_consistent : exit_inconsistent;
}

void add_options(CLI::App& next, NextCommand& command) {
  add_maps_of_trace(next, command.maps);
  add_check(next, command.maps.options);
  add_over(next, command.maps,
           "Count all maps at the exits, or the minimal models alone: these are searched for, "
           "however many maps there are, unless --max-hypotheses or --check has them all listed");
  next.add_option("--max-travels", command.bounds.travels, "Look for exits so many travels away")
      ->type_name("N")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  next.add_option("--json", command.maps.json, "Write what was found as JSON; -: alone on stdout")
      ->type_name("FILE");
  next.add_option("--svg", command.svg, "Draw the exits with the maps left at each")
      ->type_name("FILE");
  add_limits(next, command.maps.options);
}

}  // namespace

void add_next(CLI::App& app, Run& chosen) {
  add_command(app, chosen, "next", "Say which ways on from a trace are worth trying", add_options,
              run, R"(Examples:
  asterism next examples/aces-stubs.trace.json --planar
  asterism next drive.trace.json --max-travels 6 --svg exits.svg
  asterism next long-drive.trace.json --over minimal
  asterism next drive.trace.json --json - | jq '.exits[0]'
An exit is an arm to leave the last visit by, and where more travels follow, for each how many arms
clockwise of the one come in by the robot leaves: 0 leads back. docs/next.md tells what is expected.
Exit code: 0 there is a map, 1 none explains the trace, 2 stopped by a limit or Ctrl-C, 64 usage,
65 bad input, 70 internal fault or a result that cannot be written.)");
}

}  // namespace asterism
