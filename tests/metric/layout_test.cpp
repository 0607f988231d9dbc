#include "metric/layout.hpp"

#include <unistd.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <stdexcept>

#include "metric/exponential.hpp"
#include "metric/layout_residual.hpp"
#include "tests/metric/random_layout.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

double distance(const Pose2& a, const Pose2& b) {
  return std::hypot(norm(a.position() - b.position()), wrapped(a.heading_rad - b.heading_rad));
}

double farthest(const std::vector<Pose2>& a, const std::vector<Pose2>& b) {
  REQUIRE(a.size() == b.size());
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, distance(a[i], b[i]));
  return most;
}

Displacement backwards(const Displacement& d) {
  const Pose2 ahead = d.left_from_reached();
  return make_displacement(inverse(ahead), seen_from(ahead, d.covariance));
}

// The sum of squares, written out anew: rᵀ Σ⁻¹ r.
double misfit(const std::vector<Pose2>& poses, std::span<const PlaceDisplacement> displacements) {
  double sum = 0;
  for (const auto& [from, to, d] : displacements) {
    const SmallMotion error = logarithm(inverse(d.left_from_reached()) *
                                        (inverse(poses[from.index()]) * poses[to.index()]));
    const Eigen::Vector3d e(error[0], error[1], error[2]);
    const Eigen::Matrix3d covariance =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(d.covariance.data());
    sum += e.dot(covariance.inverse() * e);
  }
  return sum;
}

Eigen::Matrix3d coordinates_by_motion(const Pose2& pose) {
  const double c = std::cos(pose.heading_rad);
  const double s = std::sin(pose.heading_rad);
  Eigen::Matrix3d turn;
  turn << c, -s, 0, s, c, 0, 0, 0, 1;
  return turn;
}

}  // namespace

TEST_CASE("a residual is white, whatever the covariance", "[metric][property]") {
  RandomEngine random(1);
  for (int i = 0; i < 300; ++i) {
    const RandomLayout world = random_layout(2, 1, 0.3, random);
    const auto value = LayoutResidual(world.displacements[0].displacement)(
        world.layout_from_place[0], world.layout_from_place[1]);
    CHECK(value.residual.squaredNorm() ==
          Approx(misfit(world.layout_from_place, world.displacements)).epsilon(1e-8));
  }
}

TEST_CASE("a residual's slopes are those measured", "[metric][property]") {
  RandomEngine random(2);
  constexpr double step = 1e-6;
  for (int i = 0; i < 200; ++i) {
    const RandomLayout world = random_layout(2, 1, 0.5, random);
    const LayoutResidual residual(world.displacements[0].displacement);
    const Pose2 from = world.layout_from_place[0] * exponential({0.3, -0.2, 0.4});
    const Pose2 to = world.layout_from_place[1];
    const auto value = residual(from, to);
    for (Eigen::Index column = 0; column < 3; ++column) {
      const auto moved = [&](Pose2 pose, double by) {
        if (column == 0) pose.x_m += by;
        if (column == 1) pose.y_m += by;
        if (column == 2) pose.heading_rad += by;
        return pose;
      };
      const Eigen::Vector3d by_from =
          (residual(moved(from, step), to).residual - residual(moved(from, -step), to).residual) /
          (2 * step);
      const Eigen::Vector3d by_to =
          (residual(from, moved(to, step)).residual - residual(from, moved(to, -step)).residual) /
          (2 * step);
      const double size = 1 + by_from.norm() + by_to.norm();
      CHECK((value.by_from.col(column) - by_from).norm() < 1e-5 * size);
      CHECK((value.by_to.col(column) - by_to).norm() < 1e-5 * size);
    }
  }
}

//   0 --- 1      without a loop nothing disagrees
//         |
//         2
TEST_CASE("a chain of displacements is laid out as measured", "[metric]") {
  RandomEngine random(3);
  const RandomLayout world = random_layout(6, 5, 0.4, random);
  const Layout layout = lay_out(6, world.displacements);
  CHECK(layout.chi_squared < 1e-15);
  for (const auto& [from, to, d] : world.displacements) {
    const Pose2 seen =
        inverse(layout.layout_from_place[from.index()]) * layout.layout_from_place[to.index()];
    CHECK(distance(seen, d.left_from_reached()) < 1e-9);
  }
  // The end of the chain is as uncertain as its links together.
  const Layout two = lay_out(2, std::span(world.displacements).first(1));
  for (std::size_t i = 0; i < 9; ++i)
    CHECK(two.covariances[1][i] ==
          Approx(world.displacements[0].displacement.covariance[i]).margin(1e-12));
}

TEST_CASE("a layout is the best there is", "[metric][property]") {
  RandomEngine random(4);
  for (int i = 0; i < 100; ++i) {
    const RandomLayout world = random_layout(8, 14, 0.3, random);
    const Layout layout = lay_out(8, world.displacements);
    CHECK(layout.layout_from_place[0] == Pose2{});
    CHECK(layout.chi_squared ==
          Approx(misfit(layout.layout_from_place, world.displacements)).epsilon(1e-8));
    CHECK(layout.chi_squared <= misfit(world.layout_from_place, world.displacements));
    for (int away = 0; away < 20; ++away) {
      std::vector<Pose2> other = layout.layout_from_place;
      const std::size_t place = 1 + below(7, random);
      other[place] = other[place] * exponential({1e-3 * normal(random), 1e-3 * normal(random),
                                                 1e-4 * normal(random)});
      CHECK(misfit(other, world.displacements) >= layout.chi_squared);
    }
  }
}

TEST_CASE("covariances are those of the whole inverse", "[metric][property]") {
  RandomEngine random(5);
  for (const std::size_t places : {2U, 3U, 5U, 30U, 120U}) {
    const RandomLayout world = random_layout(places, 3 * places / 2, 0.2, random);
    const Layout layout = lay_out(places, world.displacements);
    const auto size = static_cast<Eigen::Index>(3 * places);
    Eigen::MatrixXd curvature = Eigen::MatrixXd::Zero(size, size);
    for (const auto& [from, to, displacement] : world.displacements) {
      const auto value = LayoutResidual(displacement)(layout.layout_from_place[from.index()],
                                                      layout.layout_from_place[to.index()]);
      Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(3, size);
      slope.middleCols<3>(static_cast<Eigen::Index>(3 * from.index())) =
          value.by_from * coordinates_by_motion(layout.layout_from_place[from.index()]);
      slope.middleCols<3>(static_cast<Eigen::Index>(3 * to.index())) =
          value.by_to * coordinates_by_motion(layout.layout_from_place[to.index()]);
      curvature += slope.transpose() * slope;
    }
    const Eigen::MatrixXd inverse = curvature.bottomRightCorner(size - 3, size - 3).inverse();
    CHECK(layout.covariances[0] == PoseCovariance{});
    for (std::size_t place = 1; place < places; ++place) {
      CHECK(is_covariance(layout.covariances[place]));
      for (std::size_t i = 0; i < 9; ++i) {
        const auto row = static_cast<Eigen::Index>(3 * (place - 1) + i / 3);
        const auto column = static_cast<Eigen::Index>(3 * (place - 1) + i % 3);
        CHECK(layout.covariances[place][i] ==
              Approx(inverse(row, column)).epsilon(1e-7).margin(1e-12));
      }
    }
  }
}

// Drawn from the covariances that are told, the places' errors are as large as the layout says: the
// mean of many χ² of 3 degrees of freedom is 3.
TEST_CASE("the covariances of a layout are honest", "[metric][property]") {
  RandomEngine random(6);
  constexpr int worlds = 400;
  double sum = 0;
  double misfits = 0;
  for (int i = 0; i < worlds; ++i) {
    const RandomLayout world = random_layout(7, 12, 0.02, random);
    const Layout layout = lay_out(7, world.displacements);
    const SmallMotion error =
        logarithm(inverse(layout.layout_from_place[6]) * world.layout_from_place[6]);
    const Eigen::Vector3d e(error[0], error[1], error[2]);
    const Eigen::Matrix3d covariance =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(
            layout.covariances[6].data());
    sum += e.dot(covariance.inverse() * e);
    misfits += layout.chi_squared;
  }
  // Four deviations of the mean: √(2 n / worlds).
  CHECK(sum / worlds == Approx(3).margin(4 * std::sqrt(6.0 / worlds)));
  CHECK(misfits / worlds == Approx(3 * (12 - 6)).margin(4 * std::sqrt(36.0 / worlds)));
}

TEST_CASE("neither the order nor the direction of displacements shows", "[metric][property]") {
  RandomEngine random(7);
  for (int i = 0; i < 60; ++i) {
    const std::size_t places = i % 2 == 0 ? 9 : 60;  // both solvers
    const RandomLayout world = random_layout(places, 2 * places, 0.2, random);
    const Layout layout = lay_out(places, world.displacements);
    std::vector<PlaceDisplacement> other = world.displacements;
    std::shuffle(other.begin(), other.end(), random);
    for (PlaceDisplacement& d : other) {
      if (chance(0.5, random)) d = {d.to, d.from, backwards(d.displacement)};
    }
    const Layout same = lay_out(places, other);
    CHECK(farthest(layout.layout_from_place, same.layout_from_place) < 1e-6);
    CHECK(same.chi_squared == Approx(layout.chi_squared).epsilon(1e-8));
  }
}

TEST_CASE("a mirrored map is laid out mirrored", "[metric][property]") {
  const auto mirrored = [](const Pose2& pose) {
    return Pose2{pose.x_m, -pose.y_m, -pose.heading_rad};
  };
  RandomEngine random(8);
  for (int i = 0; i < 50; ++i) {
    const RandomLayout world = random_layout(9, 16, 0.3, random);
    std::vector<PlaceDisplacement> other = world.displacements;
    for (auto& [from, to, d] : other) {
      d.y_m = -d.y_m;
      d.heading_rad = -d.heading_rad;
      for (const std::size_t at : {1U, 2U, 3U, 6U}) d.covariance[at] = -d.covariance[at];
    }
    const Layout layout = lay_out(9, world.displacements);
    Layout mirror = lay_out(9, other);
    CHECK(mirror.chi_squared == Approx(layout.chi_squared).epsilon(1e-8));
    for (Pose2& pose : mirror.layout_from_place) pose = mirrored(pose);
    CHECK(farthest(layout.layout_from_place, mirror.layout_from_place) < 1e-6);
  }
}

TEST_CASE("begun elsewhere, a layout ends the same", "[metric][property]") {
  RandomEngine random(9);
  for (int i = 0; i < 50; ++i) {
    const RandomLayout world = random_layout(9, 16, 0.2, random);
    const Layout layout = lay_out(9, world.displacements);
    const std::vector<Pose2> near = world.layout_from_place;
    const Layout same = lay_out(9, world.displacements, {.start = std::span(near).first(5)});
    CHECK(farthest(layout.layout_from_place, same.layout_from_place) < 1e-6);
  }
}

TEST_CASE("what cannot be laid out is refused", "[metric]") {
  const PoseCovariance fine = diagonal(1, 1);
  const PlaceDisplacement good{PlaceId(0), PlaceId(1), {1, 0, 0, fine}};
  CHECK_THROWS_AS(lay_out(0, {}), std::invalid_argument);
  CHECK_NOTHROW(lay_out(1, {}));
  CHECK_THROWS_AS(lay_out(2, {}), std::invalid_argument);
  CHECK_THROWS_AS(lay_out(3, std::vector{good}), std::invalid_argument);
  CHECK_THROWS_AS(lay_out(1, std::vector{good}), std::invalid_argument);
  for (PlaceDisplacement bad : {good, good, good, good}) {
    static int which = 0;
    if (which == 0) bad.to = PlaceId(0);
    if (which == 1) bad.displacement.covariance = {};
    if (which == 2) bad.displacement.covariance[1] = 2;
    if (which == 3) bad.displacement.x_m = std::numeric_limits<double>::quiet_NaN();
    ++which;
    CHECK_THROWS_AS(lay_out(2, std::vector{bad}), std::invalid_argument);
  }
}

// A square of it overflows, and no step of the solver succeeds.
TEST_CASE("what overflows is refused without a word on the standard error", "[metric]") {
  RandomEngine random(10);
  for (const std::size_t places : {3U, 30U}) {  // both solvers
    RandomLayout world = random_layout(places, places + 2, 0.3, random);
    world.displacements[1].displacement.x_m = 1e250;
    const int error_output = dup(STDERR_FILENO);
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), std::fclose);
    REQUIRE(file);
    dup2(fileno(file.get()), STDERR_FILENO);
    CHECK_THROWS_AS(lay_out(places, world.displacements), std::invalid_argument);
    dup2(error_output, STDERR_FILENO);
    close(error_output);
    CHECK(lseek(fileno(file.get()), 0, SEEK_END) == 0);
  }
}

}  // namespace asterism
