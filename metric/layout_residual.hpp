#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/layout.hpp"

namespace asterism {

/// How far two poses are from one displacement, told in its standard deviations:
/// r = W Log(λ⁻¹ χ_i⁻¹ χ_j), with WᵀW = Σ⁻¹.
class LayoutResidual {
 public:
  /// @throws std::invalid_argument if the covariance is not positive definite
  explicit LayoutResidual(const Displacement& displacement);

  struct Value {
    Eigen::Vector3d residual;
    Eigen::Matrix3d by_from;  ///< slope by a small motion of χ_i, in its frame
    Eigen::Matrix3d by_to;    ///< ... of χ_j, in its
  };
  Value operator()(const Pose2& layout_from_i, const Pose2& layout_from_j) const;

 private:
  Pose2 j_from_i_;  ///< as measured: λ⁻¹
  Eigen::Matrix3d whitening_;
};

/// Covariance of each place, the first being certain, from the curvature of the sum of squares at
/// these poses.
std::vector<PoseCovariance> place_covariances(std::span<const Pose2> layout_from_place,
                                              std::span<const PlaceDisplacement> displacements);

}  // namespace asterism
