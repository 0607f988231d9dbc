#pragma once

#include <string>

#include "core/map_report.hpp"

namespace asterism {

/// Text from a file as it may be shown on a terminal: control characters become '?'.
std::string printable(std::string text);

/// "paths ≥ 4 proved; best so far 5 paths, 12 places, 3 maps"
/// @param first_extent  what counts most in the preference, "path"
std::string bounds_text(const MapReport::Bounds& bounds, std::string_view first_extent);

/// What a report says of its minimal models: how many there are, how large, and how they are known
/// to be minimal.
std::string minimal_text(const MapReport::Minimal& minimal, const MapOptions& options);

/// How the minimal models were found, where they alone were asked for, and the end of the line.
std::string method_text(const MapOptions& options);

/// A run's findings in words. Where all maps are asked for, the report may hold the first alone.
/// @param most_maps  maps to spell out; of the others only the number is told
std::string report_text(const MapReport& report, std::size_t visits, std::size_t most_maps);
/// Likewise, of a run on the basic SSH.
std::string report_text(const SshReport& report, std::size_t views, std::size_t most_maps);

/// One map in words: which visits were to one place, the paths with their places in order.
std::string map_text(const TopologicalMap& map);

}  // namespace asterism
