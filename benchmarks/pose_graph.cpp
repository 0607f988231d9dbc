#include "benchmarks/pose_graph.hpp"

#include <array>
#include <cassert>
#include <numbers>

#include "metric/exponential.hpp"

namespace asterism {
namespace {

constexpr double pitch_m = 10;
constexpr double shift_m = 2;  // of a place, from the grid's point
constexpr double noise_m = 0.05;
constexpr double noise_rad = 0.01;

// A lower triangular root of a covariance, and the covariance.
struct Uncertainty {
  std::array<double, 9> root = {};
  PoseCovariance covariance = {};
};

Uncertainty any_uncertainty(RandomEngine& random) {
  const std::array<double, 3> deviation{noise_m, noise_m, noise_rad};
  Uncertainty result;
  auto& [root, covariance] = result;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < row; ++column)
      root[3 * row + column] = deviation[row] * between(-0.7, 0.7, random);
    root[3 * row + row] = deviation[row] * between(0.5, 1, random);
  }
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column)
      for (std::size_t k = 0; k < 3; ++k)
        covariance[3 * row + column] += root[3 * row + k] * root[3 * column + k];
  return result;
}

SmallMotion any_error(const Uncertainty& uncertainty, RandomEngine& random) {
  const SmallMotion white{normal(random), normal(random), normal(random)};
  SmallMotion result{};
  for (std::size_t i = 0; i < 9; ++i) result[i / 3] += uncertainty.root[i] * white[i % 3];
  return result;
}

}  // namespace

PoseGraph grid_pose_graph(std::size_t side, std::size_t displacements, RandomEngine& random) {
  PoseGraph graph{{Pose2{}}, {}};
  for (std::size_t place = 1; place < side * side; ++place) {
    const auto at_m = [&](std::size_t index) {
      return pitch_m * static_cast<double>(index) + between(-shift_m, shift_m, random);
    };
    const double x_m = at_m(place % side);
    const double y_m = at_m(place / side);
    graph.layout_from_place.push_back(
        {x_m, y_m, between(-std::numbers::pi, std::numbers::pi, random)});
  }
  const auto join = [&](std::size_t from, std::size_t to) {
    const Uncertainty uncertainty = any_uncertainty(random);
    const Pose2 measured = inverse(graph.layout_from_place[from]) * graph.layout_from_place[to] *
                           exponential(any_error(uncertainty, random));
    graph.displacements.push_back(
        {PlaceId(from), PlaceId(to), make_displacement(measured, uncertainty.covariance)});
  };
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      const std::size_t place = row * side + column;
      if (column + 1 < side) join(place, place + 1);
      if (row + 1 < side) join(place, place + side);
    }
  }
  for (std::size_t place = 0; graph.displacements.size() < displacements; ++place) {
    assert(place + side + 1 < side * side);
    if (place % side + 1 < side) join(place, place + side + 1);
  }
  return graph;
}

}  // namespace asterism
