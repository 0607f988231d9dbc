#pragma once

#include <string>
#include <vector>

#include "mapping/suite.hpp"

namespace asterism {

/// What is told of a trace: a line, and below it some of the differences.
std::string suite_text(const SuiteOutcome& outcome);

/// How many traces there were of each kind.
std::string suite_summary(const std::vector<SuiteOutcome>& outcomes);

/// The outcomes for programs, as JUnit XML: a test case a trace. Without times: same outcomes, same
/// bytes.
std::string junit_xml(const std::string& suite, const std::vector<SuiteOutcome>& outcomes);

}  // namespace asterism
