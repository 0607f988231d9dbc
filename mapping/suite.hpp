#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/map_report.hpp"
#include "mapping/trace_maps.hpp"

namespace asterism {

/// What became of one trace of a suite.
struct SuiteOutcome {
  enum class Kind { as_expected, recorded, differs, undecided, nothing_expected, untestable };

  std::string name;  ///< of the trace's file, without its ending
  Kind kind = Kind::as_expected;
  std::string why = {};  ///< in a few words, or a message
  std::vector<std::string> differences = {};
};

/// A folder of traces, each NAME.trace.json with what is expected of it in NAME.expect.json.
struct Suite {
  std::string folder;
  MapOptions options = {};  ///< who decides, and how many maps there may be
  bool update = false;      ///< record what comes out, where nothing was expected yet too
};

/// Asks all traces of a suite what is expected of them, in the order of their names.
/// @param told  of each trace, once it was asked
/// @throws InputError if there is none
/// @throws Error      if what comes out cannot be recorded
std::vector<SuiteOutcome> run_suite(
    const Suite& suite, const MapWatch& watch = {},
    const std::function<void(const SuiteOutcome&)>& told = [](const SuiteOutcome&) {});

}  // namespace asterism
