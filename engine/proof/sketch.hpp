#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/topological_map.hpp"
#include "core/trace.hpp"

namespace asterism {

/// A map of some visits; nothing for the others. Places are numbered by the first visit there is.
using PartialMap = std::vector<std::optional<Arrival>>;

/// What planarity is about of a partial map: its places and segments, without the rest of a map.
struct Sketch {
  TopologicalMap map;
  std::optional<TopologicalMap::Segment> last;  ///< travelled last, if there was none there yet
};

Sketch sketch_of(const Trace& trace, std::span<const std::optional<Arrival>> map);

}  // namespace asterism
