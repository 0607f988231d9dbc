#pragma once

#include <string>
#include <vector>

#include "core/pose2.hpp"

namespace asterism {

/// What is kept of a log's perception beside the trace and the maps of its places, so that it can
/// be taken up again.
struct PerceptionRecord {
  std::string perceived_by;  ///< program, version and options
  std::string trace_digest;  ///< of the trace that was perceived: see digest(const Trace&)
  std::string scans_digest;  ///< of the log's scans: see digest(std::span<const Scan>)
  std::vector<std::string> remarks = {};   ///< what is odd about the log, each in a sentence
  std::vector<Pose2> map_from_robot = {};  ///< at each scan; the map drifts

  friend bool operator==(const PerceptionRecord&, const PerceptionRecord&) = default;
};

}  // namespace asterism
