#pragma once

#include <cstddef>
#include <map>

#include "core/topological_map.hpp"

namespace asterism {

/// The path of each arm, as TopologicalMap::paths numbers them.
using PathOfArm = std::map<PlaceArm, std::size_t>;

PathOfArm paths_of_arms(const TopologicalMap& map);

/// A path's colour in all pictures, "#0072b2".
const char* path_colour(std::size_t path);

}  // namespace asterism
