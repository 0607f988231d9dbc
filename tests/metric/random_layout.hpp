#pragma once

#include <vector>

#include "core/layout.hpp"
#include "core/random.hpp"

namespace asterism {

/// Covariance with all of its off-diagonal numbers: deviations of some `scale` m and a tenth of
/// that in rad, correlated anyhow.
PoseCovariance any_covariance(double scale, RandomEngine& random);

/// A motion drawn from a covariance.
SmallMotion drawn_from(const PoseCovariance& covariance, RandomEngine& random);

/// Places here and there, joined to a whole by displacements that are each a little off.
struct RandomLayout {
  std::vector<Pose2> layout_from_place;  ///< the truth; the first is the identity
  std::vector<PlaceDisplacement> displacements;
};
RandomLayout random_layout(std::size_t places, std::size_t displacements, double scale,
                           RandomEngine& random);

}  // namespace asterism
