#pragma once

#include <vector>

#include "core/layout.hpp"

namespace asterism {

/// Places with their poses in one frame, and what was measured between them: what a layout is made
/// from, and what it becomes.
struct PoseGraph {
  std::vector<Pose2> layout_from_place = {};
  std::vector<PlaceDisplacement> displacements = {};
  std::vector<PlaceId> fixed = {};  ///< places whose poses are not to be changed
};

}  // namespace asterism
