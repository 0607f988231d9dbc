#pragma once

#include "core/ranked_map.hpp"
#include "io/json/json_node.hpp"
#include "io/json/json_writer.hpp"

namespace asterism {

/// Writes a ranked map as a JSON object: the parts of a map (io/map_json.hpp), then layout,
/// displacements and alignments, one line a pose.                                   [theory §12]
/// @throws std::invalid_argument if the layout is not that of the map or a number is not finite
void write_ranked_map(JsonWriter& json, const RankedMap& ranked);

/// Reads a ranked map and checks that it agrees with itself: a pose a place; a displacement a
/// travel, from its place to its place; alignments of returns to a place, in order of visits;
/// covariances, probabilities, and no doubt (1) where there are no degrees of freedom.
/// @throws InputError
RankedMap read_ranked_map(const JsonNode& node);

}  // namespace asterism
