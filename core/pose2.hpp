#pragma once

#include <cmath>
#include <numbers>

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

inline double dot(Point2 a, Point2 b) { return a.x_m * b.x_m + a.y_m * b.y_m; }
/// Positive where b lies counter-clockwise of a.
inline double cross(Point2 a, Point2 b) { return a.x_m * b.y_m - a.y_m * b.x_m; }
inline double norm(Point2 a) { return std::hypot(a.x_m, a.y_m); }
inline double direction(Point2 a) { return std::atan2(a.y_m, a.x_m); }
inline Point2 unit_vector(double heading_rad) {
  return {std::cos(heading_rad), std::sin(heading_rad)};
}

/// The same angle in (-π, π].
inline double wrapped(double angle_rad) {
  const double turned = std::remainder(angle_rad, 2 * std::numbers::pi);
  return turned == -std::numbers::pi ? std::numbers::pi : turned;
}

/// A rigid motion of the plane, read as `a_from_b`: it maps b's coordinates to a's, so
/// `a_from_c = a_from_b * b_from_c`. Frames: +x ahead, +y left, heading counter-clockwise in
/// (-π, π]; metres and radians.
struct Pose2 {
  double x_m = 0;
  double y_m = 0;
  double heading_rad = 0;

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

inline Pose2 inverse(const Pose2& a_from_b) {
  const double c = std::cos(a_from_b.heading_rad);
  const double s = std::sin(a_from_b.heading_rad);
  return {-c * a_from_b.x_m - s * a_from_b.y_m, s * a_from_b.x_m - c * a_from_b.y_m,
          wrapped(-a_from_b.heading_rad)};
}

}  // namespace asterism
