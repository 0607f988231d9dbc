#pragma once

#include <cstddef>
#include <cstdint>

#include "core/topological_map.hpp"

namespace asterism {

struct RandomMapOptions {
  std::size_t most_places = 20;
  std::size_t most_local_paths = 2;  ///< in one star, at least 2
  bool is_planar = true;             ///< close loops only where the stars allow it in the plane
};

/// Places and segments grown from open gateways; no visits and no paths. Its stars are any that a
/// Star can be: opposite arms beside each other, paths that meet a place twice.
TopologicalMap random_map(std::uint32_t seed, const RandomMapOptions& options);

}  // namespace asterism
