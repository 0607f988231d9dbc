#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/map_report.hpp"
#include "io/json_node.hpp"

namespace asterism {

// What maps files of both kinds hold beside the maps.                               [DESIGN §9]

std::string options_json(const MapOptions& options);
/// @throws InputError
MapOptions read_options(const JsonNode& node);

/// How many maps there are, and whether the search went to the end.
struct MapCounts {
  std::optional<std::uint64_t> consistent;
  std::optional<std::vector<std::uint64_t>> per_step;
  bool complete = true;
  std::optional<std::string> stopped_by;
};

/// As members of an object. `key` is that of per_step.
std::string counts_json(const MapCounts& counts, const std::string& key);
/// @param step  what per_step counts, "a visit"
/// @throws InputError
MapCounts read_counts(const JsonNode& root, std::string_view key, const std::string& step);

std::string minimal_json(const std::optional<MapReport::Minimal>& minimal);
/// @throws InputError
std::optional<MapReport::Minimal> read_minimal(const JsonNode& node);

/// @param first_extent  what counts most in the preference, "path"
std::string bounds_json(const MapReport::Bounds& bounds, const std::string& first_extent);
/// @throws InputError
MapReport::Bounds read_bounds(const JsonNode& node, const std::string& first_extent);

}  // namespace asterism
