#include "metric/layout_residual.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "metric/exponential.hpp"

namespace asterism {
namespace {

// Log(E) = (c x + t/2 y, c y - t/2 x, t) where E = (x, y, t) and c = (t/2) / tan(t/2).
struct Cotangent {
  explicit Cotangent(double turn_rad)
      : value(half_turn_cotangent(turn_rad)),
        slope(std::abs(turn_rad) < small_turn_rad
                  ? -turn_rad / 6
                  : (value - value * value - turn_rad * turn_rad / 4) / turn_rad) {}
  double value;
  double slope;  ///< by t
};

// Most headings are near to each other: then there is nothing to do.
double nearly_wrapped(double angle_rad) {
  return std::abs(angle_rad) < std::numbers::pi ? angle_rad : wrapped(angle_rad);
}

}  // namespace

LayoutResidual::LayoutResidual(const Displacement& displacement)
    : i_from_j_(displacement.left_from_reached()), facing_(unit_vector(displacement.heading_rad)) {
  const Eigen::LLT<Eigen::Matrix3d> root(Eigen::Map<const Matrix3>(displacement.covariance.data()));
  if (root.info() != Eigen::Success || root.rcond() < 1e-14)
    throw std::invalid_argument("a displacement's covariance is not positive definite");
  whitening_ = root.matrixL().solve(Eigen::Matrix3d::Identity());
}

// Written out, since sines and cosines are most of the time that a layout takes.
LayoutResidual::Value LayoutResidual::operator()(const Pose2& layout_from_i,
                                                 const Pose2& layout_from_j) const {
  const Point2 facing = unit_vector(layout_from_i.heading_rad);
  const Point2 apart = turned_back(facing, layout_from_j.position() - layout_from_i.position());
  // E = λ⁻¹ χ_i⁻¹ χ_j
  const Point2 off = turned_back(facing_, apart - i_from_j_.position());
  const double turn_rad =
      nearly_wrapped(layout_from_j.heading_rad - layout_from_i.heading_rad - i_from_j_.heading_rad);
  const Cotangent c(turn_rad);
  const double half = turn_rad / 2;
  const Eigen::Vector3d error(c.value * off.x_m + half * off.y_m,
                              c.value * off.y_m - half * off.x_m, turn_rad);

  Matrix3 by_off;                                            // slope of Log(E) by E's x, y and turn
  by_off << c.value, half, c.slope * off.x_m + off.y_m / 2,  //
      -half, c.value, c.slope * off.y_m - off.x_m / 2,       //
      0, 0, 1;
  const Matrix3 slope = whitening_ * by_off;
  // E's x and y turn with the layout's, by both headings; and with the heading of χ_i.
  const Point2 x = turned_back(facing_, turned_back(facing, {1, 0}));
  const Point2 y = turned_back(facing_, turned_back(facing, {0, 1}));
  const Point2 by_heading = turned_back(facing_, {apart.y_m, -apart.x_m});
  Value value;
  value.residual = whitening_ * error;
  value.by_to << slope.col(0) * x.x_m + slope.col(1) * x.y_m,
      slope.col(0) * y.x_m + slope.col(1) * y.y_m, slope.col(2);
  value.by_from << -value.by_to.leftCols<2>(),
      slope.col(0) * by_heading.x_m + slope.col(1) * by_heading.y_m - slope.col(2);
  return value;
}

}  // namespace asterism
