#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/experience.hpp"
#include "core/map_report.hpp"
#include "core/ssh_map.hpp"

namespace asterism {

/// Everything a run on an experience of the basic SSH found out: the content of its maps file.
struct SshReport {
  Experience experience;
  MapOptions options = {};
  std::optional<std::uint64_t> consistent = {};             ///< absent: not listed
  std::optional<std::vector<std::uint64_t>> per_view = {};  ///< maps after view k
  bool complete = true;
  std::optional<std::string> stopped_by = {};  ///< which limit, where not complete
  std::optional<MapReport::Minimal> minimal =
      {};                         ///< absent: nothing is consistent, or not all listed
  std::vector<SshMap> maps = {};  ///< sorted by dstates
};

}  // namespace asterism
