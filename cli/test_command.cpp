#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>

#include "cli/options.hpp"
#include "cli/suite.hpp"
#include "cli/suite_report.hpp"
#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/json_difference.hpp"
#include "io/text_file.hpp"
#include "io/trace_file.hpp"

namespace asterism {
namespace {

namespace fs = std::filesystem;
using Kind = SuiteOutcome::Kind;

constexpr const char* trace_ending = ".trace.json";
constexpr const char* expect_ending = ".expect.json";

/// The names of what has a trace or an expect file in the folder.
std::set<std::string> names_in(const std::string& folder) {
  std::set<std::string> names;
  std::error_code error;
  fs::directory_iterator entries(folder, error);
  if (error) throw InputError(folder, system_message(error.value()), "a folder of traces");
  for (const fs::directory_entry& entry : entries) {
    const std::string file = entry.path().filename().string();
    for (const std::string_view ending : {trace_ending, expect_ending})
      if (file.size() > ending.size() && file.ends_with(ending))
        names.insert(file.substr(0, file.size() - ending.size()));
  }
  if (names.empty()) throw InputError(folder, "no traces", "at least one file *.trace.json");
  return names;
}

std::vector<std::string> differences(const Expectation& found, const Expectation& expected) {
  return differences(parse_json(expectation_json(found), "found"),
                     parse_json(expectation_json(expected), "expected"));
}

SuiteOutcome outcome_of(const TestCommand& command, const std::string& name, SuiteRun& run) {
  const std::string file = (fs::path(command.folder) / name).string();
  const std::string expect_file = file + expect_ending;
  const AnyTrace any = read_any_trace_file(file + trace_ending);
  SuiteOutcome outcome{name};
  const bool is_known = fs::exists(expect_file);
  // Nothing can be expected of the basic SSH.
  const bool has_stars = std::holds_alternative<Trace>(any);
  if (!is_known && (!command.update || !has_stars)) {
    outcome.kind = Kind::nothing_expected;
    return outcome;
  }
  const Trace trace = has_stars ? std::get<Trace>(any) : read_trace_file(file + trace_ending);
  const Expectation expected = is_known ? read_expected_answers(expect_file) : default_questions();
  const auto found = run.found(trace, expected, expect_file);
  if (!found) {
    outcome.kind = Kind::undecided;
    outcome.why = "stopped by " + run.stopped_by();
    return outcome;
  }
  outcome.why = size_text(*found);
  if (is_known) outcome.differences = differences(*found, expected);
  if (command.update) {
    write_atomically(expect_file, expectation_json(*found));
    outcome.kind = Kind::recorded;
    if (!is_known) outcome.why += ", the first time";
  } else if (!outcome.differences.empty()) {
    outcome.kind = Kind::differs;
  }
  return outcome;
}

int exit_code(const std::vector<SuiteOutcome>& outcomes) {
  const auto any = [&](Kind kind) {
    return std::ranges::count(outcomes, kind, &SuiteOutcome::kind) > 0;
  };
  if (any(Kind::untestable)) return exit_bad_input;
  if (any(Kind::differs)) return exit_inconsistent;
  return any(Kind::undecided) ? exit_undecided : exit_consistent;
}

}  // namespace

int test_command(const TestCommand& command) {
  SuiteRun run(command);
  std::vector<SuiteOutcome> outcomes;
  for (const std::string& name : names_in(command.folder)) {
    try {
      outcomes.push_back(outcome_of(command, name, run));
    } catch (const InputError& error) {
      // The others can be tested all the same.
      fmt::print(stderr, "{}\n", error.what());
      outcomes.push_back({name, Kind::untestable, error.what()});
    }
    SuiteOutcome told = outcomes.back();
    if (told.kind == Kind::untestable) told.why.clear();  // it stands on stderr
    fmt::print("{}", suite_text(told));
    std::fflush(stdout);
  }
  fmt::print("{}", suite_summary(outcomes));
  if (command.junit) write_atomically(*command.junit, junit_xml(command.folder, outcomes));
  return exit_code(outcomes);
}

}  // namespace asterism
