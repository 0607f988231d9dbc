#pragma once

#include <cstddef>
#include <string>

#include "core/pose2.hpp"
#include "core/run_report.hpp"

namespace asterism {

// What is printed for programs, and is no file.                               [docs/formats.md]

/// What a run found, a model every two lines.
/// @param complete  no limit ended the run
std::string run_summary_json(const RunReport& report, bool complete);

/// How errors are spread.
struct SpreadSummary {
  double mean = 0;
  double standard_deviation = 0;
};

/// How well a trajectory agrees with surveyed relations, of which so many could be matched.
std::string relation_errors_json(std::size_t relations, std::size_t matched,
                                 const SpreadSummary& translation_m,
                                 const SpreadSummary& rotation_rad);

/// How well a trajectory agrees with the poses of a reference, of which so many could be matched.
std::string reference_errors_json(std::size_t poses, std::size_t matched, double position_rmse_m,
                                  double heading_rmse_rad, const Pose2& reference_from_layout);

}  // namespace asterism
