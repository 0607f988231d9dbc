#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "core/topological_map.hpp"

namespace asterism {

// What the answers to all kinds of queries are made of.

/// "planar map", or "planar maps" if it is not one.
std::string noun(const QueryCommand& command, std::uint64_t count);

/// As it may be shown in one line: what is read has no control characters but white space.
std::string one_line(std::string query);

/// A map as text tells it: the place of each visit.
std::string visits_text(const std::vector<Arrival>& arrivals);

/// As JSON does: an object of "visits" and "entered", or null without a map.
std::string map_json(const std::optional<std::vector<Arrival>>& map);

}  // namespace asterism
