#pragma once

#include <cstddef>
#include <vector>

#include "core/id.hpp"
#include "core/pose_covariance.hpp"
#include "core/trace.hpp"

namespace asterism {

/// λ of one travel of a map: the place reached as seen from the place left.       [BMK10, §7.1]
struct PlaceDisplacement {
  PlaceId from;
  PlaceId to;
  Displacement displacement;
};

/// χ: poses of all places of one map in one frame, that of the first place.       [BMK10, §7.1]
/// A place's frame is that of its first visit.
struct Layout {
  std::vector<Pose2> layout_from_place = {};
  std::vector<PoseCovariance> covariances = {};  ///< of each, the first place being certain
  double chi_squared = 0;  ///< Σ ‖Log(λ_k⁻¹ χ_i⁻¹ χ_j)‖²_Σk at the optimum
};

}  // namespace asterism
