#include "cli/text/suite_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "cli/text/map_text.hpp"
#include "io/picture/svg.hpp"

namespace asterism {
namespace {

using Kind = SuiteOutcome::Kind;

constexpr std::size_t most_lines = 20;

/// How a count of traces of this kind is told.
constexpr std::array<std::pair<Kind, const char*>, 6> words_of_kinds{
    {{Kind::as_expected, "as expected"},
     {Kind::recorded, "recorded"},
     {Kind::differs, "not as expected"},
     {Kind::undecided, "undecided"},
     {Kind::nothing_expected, "without an expect file"},
     {Kind::untestable, "not to be tested"}}};

std::string words_of(Kind kind) {
  return std::ranges::find(words_of_kinds, kind, &std::pair<Kind, const char*>::first)->second;
}

std::ptrdiff_t count(const std::vector<SuiteOutcome>& outcomes, Kind kind) {
  return std::ranges::count(outcomes, kind, &SuiteOutcome::kind);
}

/// Some of the differences, as they are shown.
std::vector<std::string> lines_of(const SuiteOutcome& outcome) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < std::min(outcome.differences.size(), most_lines); ++i)
    lines.push_back(printable(outcome.differences[i]));
  if (outcome.differences.size() > most_lines)
    lines.push_back(fmt::format("({} more)", outcome.differences.size() - most_lines));
  return lines;
}

std::string attribute(const std::string& text) { return xml_text(printable(text)); }

std::string xml_of(const std::string& suite, const SuiteOutcome& outcome) {
  const std::string start = fmt::format("    <testcase classname=\"{}\" name=\"{}\"",
                                        attribute(suite), attribute(outcome.name));
  const std::string message =
      words_of(outcome.kind) + (outcome.why.empty() ? "" : ": " + outcome.why);
  std::string content;
  for (const std::string& line : lines_of(outcome)) content += '\n' + xml_text(line);
  const auto with = [&](const char* element) {
    return fmt::format("{}>\n      <{} message=\"{}\">{}</{}>\n    </testcase>\n", start, element,
                       attribute(message), content, element);
  };
  switch (outcome.kind) {
    case Kind::as_expected:
    case Kind::recorded:
      return start + "/>\n";
    case Kind::differs:
      return with("failure");
    case Kind::undecided:
    case Kind::untestable:
      return with("error");
    case Kind::nothing_expected:
      return with("skipped");
  }
  return {};
}

}  // namespace

std::string suite_text(const SuiteOutcome& outcome) {
  std::string text = fmt::format("{}: {}{}\n", printable(outcome.name), words_of(outcome.kind),
                                 outcome.why.empty() ? "" : ", " + printable(outcome.why));
  for (const std::string& line : lines_of(outcome)) text += "  " + line + '\n';
  return text;
}

std::string suite_summary(const std::vector<SuiteOutcome>& outcomes) {
  std::string text = fmt::format("{} trace{}", outcomes.size(), outcomes.size() == 1 ? "" : "s");
  const char* before = ": ";
  for (const auto& [kind, words] : words_of_kinds)
    if (const auto number = count(outcomes, kind); number > 0) {
      text += fmt::format("{}{} {}", before, number, words);
      before = ", ";
    }
  return text + '\n';
}

std::string junit_xml(const std::string& suite, const std::vector<SuiteOutcome>& outcomes) {
  const std::string counts =
      fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\"", outcomes.size(),
                  count(outcomes, Kind::differs),
                  count(outcomes, Kind::undecided) + count(outcomes, Kind::untestable),
                  count(outcomes, Kind::nothing_expected));
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {}>\n  <testsuite name=\"{}\" "
      "{}>\n",
      counts, attribute(suite), counts);
  for (const SuiteOutcome& outcome : outcomes) text += xml_of(suite, outcome);
  return text + "  </testsuite>\n</testsuites>\n";
}

}  // namespace asterism
