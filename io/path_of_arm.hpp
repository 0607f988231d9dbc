#pragma once

#include <cstddef>
#include <map>

#include "core/topological_map.hpp"

namespace asterism {

/// The path of each arm. Paths are numbered by their smallest arms, as those of the map are.
using PathOfArm = std::map<PlaceArm, std::size_t>;

/// The path of each arm of a map.
PathOfArm paths_of_arms(const TopologicalMap& map);

}  // namespace asterism
