#include "mapping/suite.hpp"

#include <filesystem>
#include <set>
#include <string_view>
#include <utility>
#include <variant>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/json/json_difference.hpp"
#include "io/json/trace_file.hpp"
#include "io/shown.hpp"
#include "mapping/expected_answers.hpp"

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

SuiteOutcome outcome_of(const Suite& suite, const std::string& name, const MapWatch& watch) {
  const std::string file = (fs::path(suite.folder) / name).string();
  const std::string expect_file = file + expect_ending;
  const AnyTrace any = read_any_trace_file(file + trace_ending);
  SuiteOutcome outcome{name};
  const bool is_known = fs::exists(expect_file);
  // Nothing can be expected of the basic SSH.
  const bool has_stars = std::holds_alternative<Trace>(any);
  if (!is_known && (!suite.update || !has_stars)) {
    outcome.kind = Kind::nothing_expected;
    return outcome;
  }
  const Trace trace = has_stars ? std::get<Trace>(any) : read_trace_file(file + trace_ending);
  const Expectation expected = is_known ? read_expected_answers(expect_file) : default_questions();
  const auto [answers, stopped_by] =
      find_answers(trace, expected, suite.options, expect_file, watch);
  if (!answers) {
    outcome.kind = Kind::undecided;
    outcome.why = "stopped by " + stopped_by;
    return outcome;
  }
  outcome.why = size_text(*answers);
  if (is_known) outcome.differences = differences(*answers, expected);
  if (suite.update) {
    write_atomically(expect_file, expectation_json(*answers));
    outcome.kind = Kind::recorded;
    if (!is_known) outcome.why += ", the first time";
  } else if (!outcome.differences.empty()) {
    outcome.kind = Kind::differs;
  }
  return outcome;
}

}  // namespace

std::vector<SuiteOutcome> run_suite(const Suite& suite, const MapWatch& watch,
                                    const std::function<void(const SuiteOutcome&)>& told) {
  std::vector<SuiteOutcome> outcomes;
  for (const std::string& name : names_in(suite.folder)) {
    try {
      outcomes.push_back(outcome_of(suite, name, watch));
    } catch (const InputError& error) {
      // The others can be tested all the same.
      outcomes.push_back({name, Kind::untestable, error.what()});
    }
    told(outcomes.back());
  }
  return outcomes;
}

}  // namespace asterism
