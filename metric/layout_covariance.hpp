#pragma once

#include <Eigen/SparseCholesky>
#include <span>
#include <vector>

#include "core/layout.hpp"
#include "core/plane_covariance.hpp"
#include "metric/matrix3.hpp"

namespace asterism {

/// How well the places of a layout are known, by the curvature of its sum of squares there; the
/// first place is certain. A value: threads may read one side by side.
class LayoutCovariance {
 public:
  /// @throws std::invalid_argument if the displacements do not fix all places, or a covariance is
  ///         not positive definite
  LayoutCovariance(std::span<const Pose2> layout_from_place,
                   std::span<const PlaceDisplacement> displacements);

  /// Of each place: that of the small motion in its own frame, m, m, rad.
  std::vector<PoseCovariance> of_places() const;

  /// A point of a place, in the place's frame.
  struct PlacePoint {
    PlaceId place;
    Point2 point = {};
  };
  /// Of the way from one point to another as seen by the place of the first, along the axes of the
  /// layout: no other place, not even the layout's first, matters for it.
  PlaneCovariance seen_from(const PlacePoint& one, const PlacePoint& other) const;

 private:
  using Factor =
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>;

  std::vector<Pose2> layout_from_place_;
  std::vector<Eigen::Index> turns_;  ///< of each place: when it is eliminated
  Factor factor_;                    ///< of the curvature, places in these turns
};

}  // namespace asterism
