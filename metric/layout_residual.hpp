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
  using Matrix3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

  /// @throws std::invalid_argument if the covariance is not positive definite
  explicit LayoutResidual(const Displacement& displacement);

  struct Value {
    Eigen::Vector3d residual;
    Matrix3 by_from;  ///< slope by x_m, y_m, heading_rad of χ_i
    Matrix3 by_to;    ///< ... of χ_j
  };
  /// A heading may be any number.
  Value operator()(const Pose2& layout_from_i, const Pose2& layout_from_j) const;

 private:
  Pose2 i_from_j_;  ///< as measured: λ
  Point2 facing_;   ///< the unit vector of its heading
  Matrix3 whitening_;
};

/// Covariance of each place, the first being certain, from the curvature of the sum of squares at
/// these poses.
std::vector<PoseCovariance> place_covariances(std::span<const Pose2> layout_from_place,
                                              std::span<const PlaceDisplacement> displacements);

}  // namespace asterism
