#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/map_report.hpp"
#include "io/json/json_node.hpp"
#include "io/json/json_writer.hpp"

namespace asterism {

// What maps files of both kinds hold beside the maps.                               [theory §9]

/// Writes what was asked of a run as an object.
void write_options(JsonWriter& json, const MapOptions& options);

/// Writes the counts of maps as members of an object, in lines of their own.
/// @param key  that of the counts after each visit, or view
void write_counts(JsonWriter& json, const Findings& found, std::string_view key);

/// Writes the extents of the minimal models as an object, or null if there are none.
void write_minimal(JsonWriter& json, const std::optional<Findings::Minimal>& minimal);

/// Reads what files of both kinds tell: what was asked, the counts, the minimal models.
/// @param key   that of the counts after each step
/// @param step  what they count, "a visit"
/// @throws InputError
Findings read_findings(const JsonNode& root, std::string_view key, const std::string& step);

/// Writes what a search that was stopped knew as an object.
/// @param first_extent  what counts most in the preference, "path"
void write_bounds(JsonWriter& json, const Findings::Bounds& bounds,
                  const std::string& first_extent);
/// Reads what a search that was stopped knew.  @throws InputError
Findings::Bounds read_bounds(const JsonNode& node, const std::string& first_extent);

}  // namespace asterism
