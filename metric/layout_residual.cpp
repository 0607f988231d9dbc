#include "metric/layout_residual.hpp"

#include <Eigen/Cholesky>
#include <stdexcept>

#include "metric/exponential.hpp"

namespace asterism {
namespace {

using RowMajor3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Eigen::Matrix3d matrix(const std::array<double, 9>& numbers) {
  return Eigen::Map<const RowMajor3>(numbers.data());
}

}  // namespace

LayoutResidual::LayoutResidual(const Displacement& displacement)
    : j_from_i_(inverse(Pose2{displacement.x_m, displacement.y_m, displacement.heading_rad})) {
  const Eigen::LLT<Eigen::Matrix3d> root(matrix(displacement.covariance));
  if (root.info() != Eigen::Success || root.rcond() < 1e-14)
    throw std::invalid_argument("a displacement's covariance is not positive definite");
  whitening_ = root.matrixL().solve(Eigen::Matrix3d::Identity());
}

LayoutResidual::Value LayoutResidual::operator()(const Pose2& layout_from_i,
                                                 const Pose2& layout_from_j) const {
  const Pose2 i_from_j = inverse(layout_from_i) * layout_from_j;
  const SmallMotion error = logarithm(j_from_i_ * i_from_j);
  // Moving χ_j by δ turns E into E Exp(δ); moving χ_i, into E Exp(-Ad(χ_j⁻¹ χ_i) δ).
  const Eigen::Matrix3d slope = whitening_ * matrix(logarithm_jacobian(error));
  return {whitening_ * Eigen::Map<const Eigen::Vector3d>(error.data()),
          -slope * matrix(adjoint(inverse(i_from_j))), slope};
}

}  // namespace asterism
