#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/run_report.hpp"

namespace asterism {

// What a run found, in words and figures.

/// What became of the maps by each kind of evidence.
/// @param preferred  how many maps no other is preferred to
std::vector<RunReport::Decision> decisions(const RunReport& report, std::uint64_t preferred);

/// The ranked models, a line each, and which place each visit of the first is at.
std::string ranking_text(const RunReport& report);

/// @param complete  no limit ended the run
std::string summary_json(const RunReport& report, bool complete);

}  // namespace asterism
