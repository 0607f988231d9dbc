#pragma once

#include <Eigen/Core>

#include "core/pose_covariance.hpp"

namespace asterism {

/// Three rows and three columns: m, m, rad.
using Matrix3 = Eigen::Matrix3d;
/// A matrix that lies in memory as the nine numbers of a PoseCovariance do.
using RowMajor3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

/// Nine numbers, row by row, as a matrix.
inline Matrix3 matrix(const PoseCovariance& numbers) {
  return Eigen::Map<const RowMajor3>(numbers.data());
}

/// A matrix as nine numbers, row by row.
inline PoseCovariance numbers(const Matrix3& matrix) {
  PoseCovariance result;
  Eigen::Map<RowMajor3>{result.data()} = matrix;
  return result;
}

}  // namespace asterism
