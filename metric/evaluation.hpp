#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "core/relation.hpp"
#include "core/trajectory.hpp"

namespace asterism {

/// Stamps as far apart as this are one: what six decimals leave open.
inline constexpr double same_stamp_s = 1e-6;

/// The rigid motion, without scale, that brings points nearest to others: the least sum of squared
/// distances, in closed form. Turns by nothing where that says nothing, as for one point.
///
///   fit = argmin_T Σ_i ‖T p_i - q_i‖²,   p: points, q: others
///
/// @return  others_from_points
/// @pre  as many points as others, at least one
Pose2 rigid_fit(std::span<const Point2> points, std::span<const Point2> others);

/// How errors are spread; the deviation is that of the whole, divided by their number.
struct Spread {
  double mean = 0;
  double standard_deviation = 0;
};

/// Errors of a trajectory against surveyed relations: of each relation, the length and the angle of
/// (surveyed ⊖ estimated).
struct RelationErrors {
  std::size_t matched = 0;  ///< relations both of whose stamps the trajectory has
  Spread translation_m = {};
  Spread rotation_rad = {};
};

/// Errors of a trajectory against surveyed motions. The pose of a stamp is the first one that has
/// it, in the order of the trajectory.
/// @return  nothing if no relation has a pose at both of its stamps
std::optional<RelationErrors> relation_errors(const Trajectory& trajectory,
                                              std::span<const Relation> relations);

/// Errors of a trajectory against a reference, after the rigid fit of its positions.
struct ReferenceErrors {
  std::size_t matched = 0;  ///< stamps of the reference that the trajectory has
  double position_rmse_m = 0;
  double heading_rmse_rad = 0;
  Pose2 reference_from_layout = {};  ///< the fit
};

/// Errors of a trajectory against another of the same drive, in a frame of its own. Of poses with
/// one stamp, in either, the first counts.
///
/// @param reference  its poses are read as reference_from_robot
/// @return  nothing if no stamp is in both
std::optional<ReferenceErrors> reference_errors(const Trajectory& trajectory,
                                                const Trajectory& reference);

}  // namespace asterism
