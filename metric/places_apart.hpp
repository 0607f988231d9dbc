#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/layout.hpp"
#include "core/plane_covariance.hpp"
#include "core/ranked_map.hpp"
#include "core/trace.hpp"

namespace asterism {

/// What a place takes up of the floor: a disc round the middle of its gateways that reaches the
/// nearest of them, in the frame of the visit that saw them.
struct PlaceDisc {
  Point2 middle = {};
  double radius_m = 0;
};

/// That of a visit; nothing if no gateway was measured.
std::optional<PlaceDisc> disc_of(const Visit& visit);

/// By how much the neighbourhoods of two places may overlap.
inline constexpr double most_overlap_m = 0.3;

/// How far off a point would be that had to lie at least so far from the origin: the least squared
/// Mahalanobis distance.
///
///   min (x - point)ᵀ S⁻¹ (x - point),  |x| ≥ least_m
///
/// @param covariance  S of the point, positive definite
double misfit_of_lying_apart(Point2 point, const PlaneCovariance& covariance, double least_m);

/// The pairs of places that lie on one spot: by chance alone, layouts of places apart would be as
/// far off less often than `least_tail`.                                            [theory §12]
///
/// @param layout_from_place  χ, with its displacements
/// @param discs              one a place, in its frame; nothing where none is known: that place
///                           lies on no spot
std::vector<SharedSpot> shared_spots(std::span<const Pose2> layout_from_place,
                                     std::span<const PlaceDisplacement> displacements,
                                     std::span<const std::optional<PlaceDisc>> discs,
                                     double least_tail);

}  // namespace asterism
