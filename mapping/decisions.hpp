#pragma once

#include <cstdint>
#include <vector>

#include "core/run_report.hpp"

namespace asterism {

/// What became of the maps of a log by each kind of evidence.
/// @param report     all but its decisions
/// @param preferred  how many maps no other is preferred to
std::vector<RunReport::Decision> decisions(const RunReport& report, std::uint64_t preferred);

}  // namespace asterism
