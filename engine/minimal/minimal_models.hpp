#pragma once

#include <span>
#include <vector>

#include "core/topological_map.hpp"
#include "engine/tree/map_tree.hpp"

namespace asterism {

/// Whether a map comes before another in reports: by (visits, entered).                [theory §9]
bool is_before(std::span<const Arrival> one, std::span<const Arrival> other);

/// Data associations of the minimal models of a tree, in the order of reports.
std::vector<std::vector<Arrival>> minimal_models(const MapTree& tree);

}  // namespace asterism
