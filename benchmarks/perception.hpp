#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "benchmarks/report.hpp"
#include "io/log/carmen_log.hpp"

namespace asterism {

/// A drive to perceive.
struct PerceptionCase {
  std::string name;
  ScanSource scans;  ///< empty: not there
};

/// The log of ACES, if it is in `data_folder`, and a drive through a building like it.
std::vector<PerceptionCase> perception_cases(const std::string& data_folder);

/// How long the detector that ships takes a scan, looking for gateways at each, and gateways alone
/// from the grids it made. At most `most_scans` of each drive.
void add_perception_table(Report& report, std::vector<PerceptionCase> cases,
                          std::size_t most_scans);

}  // namespace asterism
