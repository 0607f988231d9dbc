#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/topological_map.hpp"
#include "io/json/json_node.hpp"
#include "io/json/json_writer.hpp"

namespace asterism {

/// Writes an arm of a place: an array of both their numbers.
void write_json(JsonWriter& json, PlaceArm arm);

/// Writes where each visit was as an object of "visits", its place, and "entered", the arm it came
/// in by; null of a visit that is not told of.
void write_arrivals(JsonWriter& json, std::span<const std::optional<Arrival>> arrivals);

/// Writes where each visit of a whole map was, likewise, or null without a map.
void write_arrivals(JsonWriter& json, const std::optional<std::vector<Arrival>>& arrivals);

/// Writes a map as an object, a line a member.                                       [theory §9]
void write_map(JsonWriter& json, const TopologicalMap& map);

/// Writes the members of a map, for an object that has more of them.
void write_map_parts(JsonWriter& json, const TopologicalMap& map);

/// Reads a map and checks all that follows from its visits and stars: places numbered by first
/// visit; arms entered and left by that are there and have gateways; each gateway in at most one
/// segment; segments and paths as the travels make them, in the one order there is for them.
/// @throws InputError
TopologicalMap read_map(const JsonNode& node);

/// Reads the members of a map from an object that may have other keys too, and checks what read_map
/// does.
/// @param may_be_in_pieces  a travel may lack both its arms: the trace was cut there
/// @throws InputError
TopologicalMap read_map_parts(const JsonNode& node, bool may_be_in_pieces);

}  // namespace asterism
