#pragma once

#include "core/layout.hpp"
#include "metric/matrix3.hpp"

namespace asterism {

/// How far two poses are from one displacement, told in its standard deviations:
/// r = W Log(λ⁻¹ χ_i⁻¹ χ_j), with WᵀW = Σ⁻¹. A value: threads may read one side by side.
class LayoutResidual {
 public:
  /// Numbers row by row, as Ceres takes them.
  using Matrix3 = RowMajor3;

  /// @throws std::invalid_argument if the covariance is not positive definite
  explicit LayoutResidual(const Displacement& displacement);

  /// The residual at two poses, and its slopes there.
  struct Value {
    Eigen::Vector3d residual;
    Matrix3 by_from;  ///< slope by x_m, y_m, heading_rad of χ_i
    Matrix3 by_to;    ///< slope by x_m, y_m, heading_rad of χ_j
  };
  /// @param layout_from_i  χ_i, the pose of the place left; its heading may be any number
  /// @param layout_from_j  χ_j, the pose of the place reached, alike
  Value operator()(const Pose2& layout_from_i, const Pose2& layout_from_j) const;

 private:
  Pose2 i_from_j_;  ///< as measured: λ
  Point2 facing_;   ///< the unit vector of its heading
  Matrix3 whitening_;
};

}  // namespace asterism
