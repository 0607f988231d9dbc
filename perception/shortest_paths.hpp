#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "perception/skeleton.hpp"

namespace asterism {

/// Of each point of a skeleton, the one before it on the shortest path from where paths start, and
/// how long that path is, in cells.
struct ShortestPaths {
  std::vector<std::optional<std::size_t>> before = {};
  std::vector<double> length = {};  ///< infinite: not connected
};

/// How far it is from a point of a skeleton to one beside it, in cells: 1, or √2 across a corner.
double step_length(const Skeleton& skeleton, std::size_t a, std::size_t b);

/// The shortest paths from any of some points of a skeleton to all others, by Dijkstra's algorithm.
///
/// @param starts  points
/// @param open    of each point, whether paths may lead to it; starts need not be
ShortestPaths shortest_paths(const Skeleton& skeleton, const std::vector<std::size_t>& starts,
                             const std::vector<bool>& open);

}  // namespace asterism
