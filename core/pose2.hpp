#pragma once

#include <cmath>
#include <span>

#include "core/angle.hpp"

namespace asterism {

/// A point in the plane, or the difference of two; metres.
struct Point2 {
  double x_m = 0;
  double y_m = 0;

  friend Point2 operator+(Point2 a, Point2 b) { return {a.x_m + b.x_m, a.y_m + b.y_m}; }
  friend Point2 operator-(Point2 a, Point2 b) { return {a.x_m - b.x_m, a.y_m - b.y_m}; }
  friend Point2 operator*(double s, Point2 a) { return {s * a.x_m, s * a.y_m}; }
  friend bool operator==(Point2 a, Point2 b) = default;
};

/// The inner product of two vectors, m².
inline double dot(Point2 a, Point2 b) { return a.x_m * b.x_m + a.y_m * b.y_m; }
/// The outer product of two vectors, m². Positive where b lies counter-clockwise of a.
inline double cross(Point2 a, Point2 b) { return a.x_m * b.y_m - a.y_m * b.x_m; }
/// The length of a vector, m.
inline double norm(Point2 a) { return std::hypot(a.x_m, a.y_m); }
/// Where a vector points: counter-clockwise from +x, rad, in [-π, π].
inline double direction(Point2 a) { return std::atan2(a.y_m, a.x_m); }
/// The vector of length 1 that points there.
inline Point2 unit_vector(double heading_rad) {
  return {std::cos(heading_rad), std::sin(heading_rad)};
}
/// The vector of length 1 from one point towards another.   @pre the points differ
inline Point2 unit_towards(Point2 from, Point2 to) { return (1 / norm(to - from)) * (to - from); }
/// A vector turned by a quarter counter-clockwise: what is left where `ahead` is ahead.
inline Point2 left_of(Point2 ahead) { return {-ahead.y_m, ahead.x_m}; }

/// A vector turned as far as `facing` is turned from +x.   @param facing  of length 1
inline Point2 turned(Point2 facing, Point2 vector) {
  return {facing.x_m * vector.x_m - facing.y_m * vector.y_m,
          facing.y_m * vector.x_m + facing.x_m * vector.y_m};
}
/// A vector turned back as far: turned_back(facing, turned(facing, v)) = v.
/// @param facing  of length 1
inline Point2 turned_back(Point2 facing, Point2 vector) {
  return {dot(facing, vector), cross(facing, vector)};
}

/// The middle of points.   @pre at least one
inline Point2 mean(std::span<const Point2> points) {
  Point2 sum;
  for (const Point2 point : points) sum = sum + point;
  return 1 / static_cast<double>(points.size()) * sum;
}

/// A rigid motion of the plane, read as `a_from_b`: it maps b's coordinates to a's, so
/// `a_from_c = a_from_b * b_from_c`. Frames: +x ahead, +y left, heading counter-clockwise in
/// (-π, π]; metres and radians.
struct Pose2 {
  double x_m = 0;
  double y_m = 0;
  double heading_rad = 0;

  /// Where b's origin is, in a's coordinates.
  Point2 position() const { return {x_m, y_m}; }

  friend Point2 operator*(const Pose2& a_from_b, Point2 in_b) {
    const double c = std::cos(a_from_b.heading_rad);
    const double s = std::sin(a_from_b.heading_rad);
    return {a_from_b.x_m + c * in_b.x_m - s * in_b.y_m, a_from_b.y_m + s * in_b.x_m + c * in_b.y_m};
  }
  friend Pose2 operator*(const Pose2& a_from_b, const Pose2& b_from_c) {
    const Point2 at = a_from_b * b_from_c.position();
    return {at.x_m, at.y_m, wrapped(a_from_b.heading_rad + b_from_c.heading_rad)};
  }
  friend bool operator==(const Pose2&, const Pose2&) = default;
};

/// The motion back, b_from_a.
inline Pose2 inverse(const Pose2& a_from_b) {
  const double c = std::cos(a_from_b.heading_rad);
  const double s = std::sin(a_from_b.heading_rad);
  return {-c * a_from_b.x_m - s * a_from_b.y_m, s * a_from_b.x_m - c * a_from_b.y_m,
          wrapped(-a_from_b.heading_rad)};
}

}  // namespace asterism
