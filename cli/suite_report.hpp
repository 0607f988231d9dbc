#pragma once

#include <string>
#include <vector>

namespace asterism {

/// What became of one trace of a suite.
struct SuiteOutcome {
  enum class Kind { as_expected, recorded, differs, undecided, nothing_expected, untestable };

  std::string name;  ///< of the trace's file, without its ending
  Kind kind = Kind::as_expected;
  std::string why = {};  ///< in a few words, or a message
  std::vector<std::string> differences = {};
};

/// What is told of a trace: a line, and below it some of the differences.
std::string suite_text(const SuiteOutcome& outcome);

/// How many traces there were of each kind.
std::string suite_summary(const std::vector<SuiteOutcome>& outcomes);

/// The same for programs, as JUnit XML: a test case a trace. Without times: same outcomes, same
/// bytes.
std::string junit_xml(const std::string& suite, const std::vector<SuiteOutcome>& outcomes);

}  // namespace asterism
