#pragma once

#include <cstddef>
#include <vector>

#include "core/layout.hpp"
#include "core/random.hpp"

namespace asterism {

/// A map to lay out, and where its places are.
struct PoseGraph {
  std::vector<Pose2> layout_from_place = {};  ///< the truth; the first is the identity
  std::vector<PlaceDisplacement> displacements = {};
};

/// Places 10 m apart on a grid of `side` rows and columns, shifted and facing anyhow; displacements
/// between neighbours in a row or column, then across the grid's squares, each a little off by a
/// full covariance of its own, as much as a travel of 10 m is.
/// @pre  2 side (side - 1) <= displacements <= 2 side (side - 1) + (side - 1)²
PoseGraph grid_pose_graph(std::size_t side, std::size_t displacements, RandomEngine& random);

}  // namespace asterism
