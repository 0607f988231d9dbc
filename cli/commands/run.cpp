#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <list>
#include <optional>
#include <span>
#include <utility>

#include "cli/asked_maps.hpp"
#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/log_options.hpp"
#include "cli/option_checks.hpp"
#include "cli/progress.hpp"
#include "cli/text/map_text.hpp"
#include "cli/text/run_text.hpp"
#include "core/error.hpp"
#include "io/json/summary_json.hpp"
#include "io/picture/report_text.hpp"
#include "mapping/log_files.hpp"
#include "mapping/log_maps.hpp"
#include "mapping/result_folder.hpp"

namespace asterism {
namespace {

struct RunCommand {
  std::string log;
  std::string folder;
  LogQuestion asked;
  std::vector<std::string> assume;  ///< texts of assumptions
  std::optional<std::string> trace;
  std::optional<std::string> map_folder;
  bool afresh = false;
  bool json = false;
};

/// Tells what each stage found, on stdout unless that is for JSON, and how long it took, on stderr.
class Telling {
 public:
  explicit Telling(const RunCommand& command) : command_(command) {}

  LogWatch watch() {
    LogWatch watch;
    watch.read = [this](const LogReader& log, const Perceived& so_far) {
      (*reading_)(log, so_far.scans.size(), so_far.trace.visits.size());
    };
    watch.maps.stop = [this](const TraceMaps& maps) {
      finding_.emplace_back(maps.trace().visits.size(), command_.asked.maps.time_limit_s);
      return finding_.back().stop(maps);
    };
    watch.maps.found = [this](const std::string& what_now) { finding_.back().grown(what_now); };
    watch.perceived = [this](const Perceived& perceived) { tell(perceived); };
    watch.explained = [this](const ExplainedTrace& explained) { tell_counts(explained); };
    watch.ranked = [this](const ExplainedTrace& explained) { tell_ranked(explained); };
    return watch;
  }

  void tell(const std::string& found) const {
    if (!command_.json) fmt::print("{}", found);
    std::fflush(stdout);
  }

  void tell_remarks(std::span<const std::string> remarks) const {
    for (const std::string& remark : remarks) tell("note: " + remark + '\n');
  }

  StageTimes stage_is_over;

 private:
  void tell(const Perceived& perceived) {
    reading_.reset();
    stage_is_over(perceived.is_kept ? "read" : "perceive");
    visits_ = perceived.trace.visits.size();
    tell(fmt::format("{}: {} scans, {} visits\n", printable(perceived.trace.name),
                     perceived.scans.size(), visits_));
    if (perceived.is_kept)
      tell(command_.trace ? "places as told by " + *command_.trace + '\n'
                          : "places as perceived before, kept in " + command_.folder +
                                "/log.lpm; --afresh perceives again\n");
    tell_remarks(perceived.remarks);
  }

  /// What growing the tree found; the minimal models themselves are for the ranking to show.
  void tell_counts(const ExplainedTrace& explained) {
    finding_.clear();
    stage_is_over("grow");
    MapReport report = explained.report;
    report.maps.clear();
    const std::string text = report_text(report, visits_, 0);
    tell(text.substr(text.find('\n') + 1));  // its first line is told before
  }

  void tell_ranked(const ExplainedTrace& explained) {
    stage_is_over("rank");
    const MapReport& report = explained.report;
    if (!report.explained_visits) return;
    if (report.complete) tell(explained.why + '\n');
    if (!explained.parts.empty())
      tell(fmt::format("ranked: maps in {}\n", pieces_text(report.ranked.front().map)));
    else if (!report.ranked.empty())
      tell(fmt::format("ranked: maps of the visits up to {}; later ones are drawn as measured\n",
                       *report.explained_visits - 1));
  }

  const RunCommand& command_;
  std::optional<ReadProgress> reading_{std::in_place};
  std::list<Progress> finding_;  ///< of each trace whose maps are looked for
  std::size_t visits_ = 0;
};

/// The trace that was told, with the place maps that lie beside it if none other are named.
ToldTrace told_trace(const RunCommand& command) {
  const std::filesystem::path beside = std::filesystem::path(*command.trace).parent_path();
  return {*command.trace, command.map_folder.value_or((beside / "log.lpm").string())};
}

int run(RunCommand command) {
  command.asked.assumptions = read_assumptions(command.assume);
  if (command.trace) command.asked.told = told_trace(command);
  if (!command.afresh) command.asked.results_before = command.folder;
  ResultFolder results(command.folder);
  Telling telling(command);
  LogMaps maps = map_log(command.log, command.asked, telling.watch());
  const bool is_complete = maps.explained.report.complete;
  const std::string fault = maps.models.empty() ? "" : maps.models.front().fault;
  const std::size_t remarks_told = maps.perceived.remarks.size();
  const RunReport report = write_log_files(results.unfinished(), std::move(maps));
  results.finish();
  telling.stage_is_over("draw");

  if (!fault.empty())
    throw Error(command.folder + ": found " + fault +
                "; expected to draw rank 1; all else is there");
  telling.tell(ranking_text(report));
  telling.tell_remarks(std::span(report.remarks).subspan(remarks_told));
  if (command.json)
    fmt::print("{}", run_summary_json(report, is_complete));
  else
    fmt::print("results are in {}: look at report.html first\n", command.folder);
  if (!is_complete) return exit_undecided;
  return report.unexplained ? exit_inconsistent : exit_consistent;
}

void add_options(CLI::App& log, RunCommand& command) {
  add_log(log, command.log, command.asked.laser);
  log.add_option("-o,--output", command.folder, "Folder for the results")
      ->type_name("DIR")
      ->required();
  log.add_flag("--planar", command.asked.maps.theory.planar,
               "Keep the maps that can be drawn in the plane");
  add_assumptions(log, command.assume);
  CLI::Option* const trace =
      log.add_option("--trace", command.trace,
                     "A trace in place of the one perceived: a run's log.trace.json, corrected")
          ->type_name("FILE");
  log.add_option("--lpm", command.map_folder,
                 "Folder log.lpm of a run on the same log [log.lpm beside the trace]")
      ->type_name("DIR")
      ->needs(trace);
  log.add_flag("--afresh", command.afresh,
               "Perceive the log again, though an earlier run left in DIR what it perceived");
  log.add_option("--models", command.asked.ranking.models, "Maps to rank and draw")
      ->type_name("N")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  log.add_option_function<std::string>(
         "--rank",
         [&](const std::string& which) { command.asked.only_minimal = which == "minimal"; },
         "Rank all maps, or the minimal models alone: these are searched for, and the others not "
         "counted, unless --max-hypotheses has them all listed [all]")
      ->check(CLI::IsMember({"all", "minimal"}));
  log.add_flag_callback(
      "--storeys", [&] { command.asked.ranking.on_one_floor = false; },
      "The building has several floors: places may lie above each other");
  add_gateway_width(log, command.asked.detector);
  log.add_option("--resolution", command.asked.resolution_m, "Side of a cell of the global map")
      ->type_name("M")
      ->check(number_between(0.01, 1, "metres, 0.01 to 1"))
      ->capture_default_str();
  log.add_option("--certify", command.asked.maps.certify_s,
                 "Seconds the solver has to prove the minimal maps minimal; 0: off")
      ->type_name("S")
      ->check(number_between(0, 1e6, "seconds, 0 or more"))
      ->capture_default_str();
  command.asked.maps.max_hypotheses = 10'000'000;
  log.add_option("--max-hypotheses", command.asked.maps.max_hypotheses,
                 "Stop growing maps where a visit leaves more")
      ->type_name("N")
      ->check(whole_number)
      ->capture_default_str();
  log.add_option("--time-limit", command.asked.maps.time_limit_s,
                 "Stop growing maps after this many seconds")
      ->type_name("S")
      ->check(seconds);
  log.add_flag("--json", command.json, "Print a summary as JSON");
  log.parse_complete_callback([&] {
    // The default is for listing; what is asked for has the maps listed.
    if (command.asked.only_minimal && log.get_option("--max-hypotheses")->count() == 0)
      command.asked.maps.max_hypotheses.reset();
  });
}

}  // namespace

void add_run(CLI::App& app, Run& chosen) {
  add_command(app, chosen, "run", "Map a building from a laser log, all the way", add_options, run,
              R"(Examples:
  asterism run drive.log.xz -o drive
  asterism run drive.log -o drive --planar --models 10
  asterism run drive.log -o drive --max-range 8.18 --min-gateway-width-m 0.9 --json
  asterism run drive.log -o drive --assume 'same(0, 8)'
  asterism run drive.log -o corrected --trace edited.trace.json --lpm drive/log.lpm
Perceives the trace, grows every map that explains it, ranks them by preference and layout, and
draws the best: DIR/report.html shows it all; DIR/log.trace.json, maps.json; of the best model
trajectory.tum, map.pgm, map.yaml, map.png, layout.g2o, map.graphml, map.dot, routes.geojson and
routes.osm, of the others the same in model-2, model-3 ... What an earlier run left there is
replaced; what it perceived of the same log is taken up, so that another question takes seconds.
Exit code: 0 a map explains the trace, 1 none does: it is cut as few times as can be, and the best
maps of the parts are drawn in one frame; 2 a limit ended the run, 64 usage, 65 bad input or no place in it, 70 internal fault or a
result that cannot be written.)");
}

}  // namespace asterism
