#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>

#include "cli/asked_maps.hpp"
#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/progress.hpp"
#include "cli/text/suite_report.hpp"
#include "io/atomic_file.hpp"
#include "mapping/suite.hpp"

namespace asterism {
namespace {

using Kind = SuiteOutcome::Kind;

struct TestCommand {
  Suite suite;
  std::optional<std::string> junit;  ///< file
};

void tell(SuiteOutcome outcome) {
  if (outcome.kind == Kind::untestable) {
    fmt::print(stderr, "{}\n", outcome.why);
    outcome.why.clear();
  }
  fmt::print("{}", suite_text(outcome));
  std::fflush(stdout);
}

int exit_code(const std::vector<SuiteOutcome>& outcomes) {
  const auto any = [&](Kind kind) {
    return std::ranges::count(outcomes, kind, &SuiteOutcome::kind) > 0;
  };
  if (any(Kind::untestable)) return exit_bad_input;
  if (any(Kind::differs)) return exit_inconsistent;
  return any(Kind::undecided) ? exit_undecided : exit_consistent;
}

int run(const TestCommand& command) {
  const auto& limit_s = command.suite.options.time_limit_s;
  const Deadline deadline = limit_s ? deadline_in(*limit_s) : Deadline::max();
  std::optional<Progress> progress;
  MapWatch watch;
  watch.stop = [&](const TraceMaps& maps) {
    const auto left_s = limit_s ? std::optional(std::max(0.0, seconds_until(deadline))) : limit_s;
    progress.emplace(maps.trace().visits.size(), left_s);
    return progress->stop();
  };
  const std::vector<SuiteOutcome> outcomes =
      run_suite(command.suite, watch, [&](const SuiteOutcome& outcome) {
        progress.reset();
        tell(outcome);
      });
  fmt::print("{}", suite_summary(outcomes));
  if (command.junit) write_atomically(*command.junit, junit_xml(command.suite.folder, outcomes));
  return exit_code(outcomes);
}

void add_options(CLI::App& test, TestCommand& command) {
  test.add_option("folder", command.suite.folder, "Folder of *.trace.json and *.expect.json")
      ->required();
  test.add_option("--check", command.suite.options.check,
                  "Who decides: native, the solver alone, or both compared at every candidate")
      ->check(CLI::IsMember({"native", "solver", "both"}))
      ->capture_default_str();
  test.add_flag("--update", command.suite.update, "Record what comes out instead");
  test.add_option("--junit", command.junit, "Write the results as JUnit XML")->type_name("FILE");
  add_limits(test, command.suite.options);
}

}  // namespace

void add_test(CLI::App& app, Run& chosen) {
  add_command(app, chosen, "test", "Ask a folder of traces what is expected of them", add_options,
              run, R"(Examples:
  asterism test tests/traces
  asterism test my-traces --junit report.xml --time-limit 60
  asterism test my-traces --update
Of each NAME.trace.json, NAME.expect.json says what is asked and what must come out: how many maps
there are, which are minimal, and the answers to queries; docs/formats.md tells how. --update records
what comes out, of all maps and the planar ones where nothing was asked before.
Exit code: 0 all is as expected, 1 something is not, 2 a limit or Ctrl-C left something undecided,
64 usage, 65 bad input, 70 internal fault or a result that cannot be written.)");
}

}  // namespace asterism
