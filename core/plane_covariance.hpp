#pragma once

#include <cmath>

#include "core/pose2.hpp"

namespace asterism {

/// How points spread round their mean, or how well a point is known: a symmetric matrix, m².
///
/// Its eigenvalues are middle() ± half(), that of the direction along() being the larger.
struct PlaneCovariance {
  double xx = 0;
  double xy = 0;
  double yy = 0;

  /// The mean of both eigenvalues, m².
  double middle() const { return (xx + yy) / 2; }
  /// Half of what the eigenvalues differ, m².
  double half() const { return std::hypot((xx - yy) / 2, xy); }
  /// The direction of the largest spread, of length 1: either one of the two.
  Point2 along() const { return unit_vector(0.5 * std::atan2(2 * xy, xx - yy)); }
};

/// Mean and covariance of points, taken in one by one.
class PointSpread {
 public:
  /// Takes in a point: best told from one amid them, since squares of large numbers cancel badly.
  void add(Point2 point) {
    ++count_;
    sum_ = sum_ + point;
    xx_ += point.x_m * point.x_m;
    xy_ += point.x_m * point.y_m;
    yy_ += point.y_m * point.y_m;
  }
  /// How many points were taken in.
  double count() const { return count_; }
  /// Their middle.   @pre at least one
  Point2 mean() const { return (1 / count_) * sum_; }
  /// Their covariance, divided by their number.   @pre at least one
  PlaneCovariance covariance() const {
    const Point2 middle = mean();
    return {xx_ / count_ - middle.x_m * middle.x_m, xy_ / count_ - middle.x_m * middle.y_m,
            yy_ / count_ - middle.y_m * middle.y_m};
  }

 private:
  double count_ = 0;
  Point2 sum_ = {};
  double xx_ = 0;
  double xy_ = 0;
  double yy_ = 0;
};

}  // namespace asterism
