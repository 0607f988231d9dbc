#pragma once

#include <iosfwd>
#include <span>
#include <string>

#include "core/topological_map.hpp"
#include "io/json_node.hpp"

namespace asterism {

/// Writes a map as a JSON object, one line a part.                                  [DESIGN §9]
/// @param more  parts of their own lines, which follow the map's
void write_map(std::ostream& out, const TopologicalMap& map,
               std::span<const std::string> more = {});

/// Reads a map and checks all that follows from its visits and stars: places numbered by first
/// visit; arms entered and left by that are there and have gateways; each gateway in at most one
/// segment; segments and paths as the travels make them, in the one order there is for them.
/// @throws InputError
TopologicalMap read_map(const JsonNode& node);

/// The same of an object that may have other keys too.
TopologicalMap read_map_parts(const JsonNode& node);

}  // namespace asterism
