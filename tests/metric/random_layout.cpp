#include "tests/metric/random_layout.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "metric/exponential.hpp"

namespace asterism {
namespace {

// Lower triangle of a root of the covariance.
std::array<double, 9> root(const PoseCovariance& c) {
  const double a = std::sqrt(c[0]);
  const double b = c[3] / a;
  const double d = std::sqrt(c[4] - b * b);
  const double e = c[6] / a;
  const double f = (c[7] - e * b) / d;
  return {a, 0, 0, b, d, 0, e, f, std::sqrt(c[8] - e * e - f * f)};
}

}  // namespace

PoseCovariance any_covariance(double scale, RandomEngine& random) {
  PoseCovariance result{};
  for (int mixture = 0; mixture < 4; ++mixture) {
    const SmallMotion m{scale * normal(random), scale * normal(random),
                        0.1 * scale * normal(random)};
    for (std::size_t i = 0; i < 9; ++i) result[i] += m[i / 3] * m[i % 3] / 4;
  }
  for (std::size_t i = 0; i < 3; ++i) result[4 * i] *= 1.1;
  return result;
}

SmallMotion drawn_from(const PoseCovariance& covariance, RandomEngine& random) {
  const auto lower = root(covariance);
  const SmallMotion white{normal(random), normal(random), normal(random)};
  SmallMotion result{};
  for (std::size_t i = 0; i < 9; ++i) result[i / 3] += lower[i] * white[i % 3];
  return result;
}

RandomLayout random_layout(std::size_t places, std::size_t displacements, double scale,
                           RandomEngine& random) {
  RandomLayout layout{{Pose2{}}, {}};
  for (std::size_t i = 1; i < places; ++i)
    layout.layout_from_place.push_back({between(-30, 30, random), between(-30, 30, random),
                                        between(-std::numbers::pi, std::numbers::pi, random)});
  for (std::size_t k = 0; k < displacements; ++k) {
    // The first ones reach each place from one before it.
    const std::size_t to = k + 1 < places ? k + 1 : below(places, random);
    std::size_t from = below(k + 1 < places ? to : places, random);
    if (from == to) from = (from + 1) % places;
    const PoseCovariance covariance = any_covariance(scale, random);
    const Pose2 moved = inverse(layout.layout_from_place[from]) * layout.layout_from_place[to] *
                        exponential(drawn_from(covariance, random));
    layout.displacements.push_back(
        {PlaceId(from), PlaceId(to), make_displacement(moved, covariance)});
  }
  return layout;
}

}  // namespace asterism
