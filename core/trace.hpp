#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/pose_covariance.hpp"
#include "core/star.hpp"

namespace asterism {

/// Pose of the place reached in the frame of the place left.       [BMK10, §7.1] [theory §2]
/// Its covariance is that of a small motion in the frame of the place reached: see PoseCovariance.
struct Displacement {
  double x_m = 0;               ///< +x ahead
  double y_m = 0;               ///< +y left
  double heading_rad = 0;       ///< counter-clockwise
  PoseCovariance covariance{};  ///< row by row; m, m, rad

  /// The pose itself.
  Pose2 left_from_reached() const { return {x_m, y_m, heading_rad}; }

  friend bool operator==(const Displacement&, const Displacement&) = default;
};

/// The displacement with this pose and covariance.
inline Displacement make_displacement(const Pose2& left_from_reached,
                                      const PoseCovariance& covariance) {
  return {left_from_reached.x_m, left_from_reached.y_m, left_from_reached.heading_rad, covariance};
}

/// A gateway as measured, in its visit's frame.
struct MeasuredGateway {
  std::string arm;  ///< name in the visit's star, "a+"
  double x_m = 0;
  double y_m = 0;
  double heading_rad = 0;  ///< outward
  double width_m = 0;

  /// Its middle, in the visit's frame.
  Point2 middle() const { return {x_m, y_m}; }
  /// Its frame: the origin in its middle, +x outward.
  Pose2 visit_from_gateway() const { return {x_m, y_m, heading_rad}; }

  friend bool operator==(const MeasuredGateway&, const MeasuredGateway&) = default;
};

/// One stay at a place: the star seen, the arm entered by, the arm left by.        [theory §2]
/// The arm entered by leads *back*, so the robot arrived facing the opposite arm.
struct Visit {
  Star star;
  std::optional<std::size_t> entered_by = {};  ///< arm of `star` with a gateway
  std::optional<std::size_t> left_by = {};     ///< arm of `star` with a gateway

  // What follows is carried along; no map depends on it.
  std::optional<Displacement> displacement = {};
  std::optional<std::array<long long, 2>> scans = {};  ///< first, last
  std::optional<std::array<double, 2>> stamps_s = {};  ///< in, out
  std::vector<MeasuredGateway> gateways = {};
  std::optional<std::string> lpm = {};         ///< file of the place's map, relative to the trace
  std::optional<std::string> true_place = {};  ///< ground truth, for tests
  std::string extensions = "{}";               ///< the keys that start with x_, a JSON object

  friend bool operator==(const Visit&, const Visit&) = default;
};

/// The sequence of visits.
///
/// Readers guarantee: at least one visit; entered_by in all but the first; left_by in all but the
/// last; these arms have gateways. Where a trace is cut, arms are absent, too: see cut().
struct Trace {
  std::string name;
  std::vector<Visit> visits;
  std::string extensions = "{}";  ///< the keys that start with x_, a JSON object
};

/// Checks what readers guarantee of a trace.
/// @throws std::invalid_argument "/visits/3/left_by: found ...; expected ..." if a guarantee does
///         not hold
void require_valid(const Trace& trace);

/// Visits `first` to before `last`, as a trace of its own.
/// @pre  first < last <= number of visits
Trace part_of(const Trace& trace, std::size_t first, std::size_t last);

/// The trace in pieces: none of these visits is known to be travelled to from the one before. Both
/// lose the arms of that travel; its displacement stays.
Trace cut(Trace trace, std::span<const std::size_t> before);

/// A drive walked backwards: visits in reverse order, entered and left swapped. Measured
/// extras are dropped, since they belong to the forward drive.
Trace reversed(const Trace& trace);

}  // namespace asterism
