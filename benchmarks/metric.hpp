#pragma once

#include <cstddef>
#include <vector>

#include "benchmarks/perception.hpp"
#include "benchmarks/report.hpp"

namespace asterism {

/// How long a drive's trajectory and global map take, in cells of 0.05 m. The poses are the
/// wheels', which draws as many cells as better ones would. At most `most_scans` of each drive.
void add_global_map_table(Report& report, std::vector<PerceptionCase> cases,
                          std::size_t most_scans);

/// How long a grid of places takes to lay out, from scratch and from what was found, and how far
/// the result is from the truth. At most `most_places`.
void add_layout_table(Report& report, std::size_t most_places);

}  // namespace asterism
