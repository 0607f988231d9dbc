#pragma once

#include "metric/matrix3.hpp"

namespace asterism {

/// The equations of Gauss and Newton for a sum of squares of residuals over small motions of one
/// frame: curvature · motion = slope.
struct GaussNewton {
  Matrix3 curvature = Matrix3::Zero();
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();

  /// Takes in one residual.
  ///
  /// @param jacobian     slope of the residual by the motion: by m, m, rad
  /// @param information  how well it is known: 1 / variance
  void add(const Eigen::Vector3d& jacobian, double residual, double information) {
    curvature += information * jacobian * jacobian.transpose();
    slope -= information * residual * jacobian;
  }
};

}  // namespace asterism
