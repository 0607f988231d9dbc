#include "metric/wall_fit.hpp"

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>

#include "metric/exponential.hpp"
#include "tests/metric/seen_place.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

constexpr double corridor_width_m = 2;
constexpr double walls_radius_m = 12;
// A start off by 0.7 m and 0.2 rad at most is as well known as that.
constexpr PoseCovariance information_of_start = diagonal(4, 40);
// A cell is 0.1 m: a wall's pieces lie on its middle line, to a part of that.
constexpr double fine_m = 0.03;
constexpr double fine_rad = 0.01;

using Matrix3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Matrix3 matrix(const PoseCovariance& numbers) { return Eigen::Map<const Matrix3>(numbers.data()); }

double apart_m(const Pose2& a, const Pose2& b) { return norm(a.position() - b.position()); }
double apart_rad(const Pose2& a, const Pose2& b) {
  return std::abs(wrapped(a.heading_rad - b.heading_rad));
}

IdealWorld world_named(const std::string& name) {
  for (const IdealWorld& world : ideal_worlds(corridor_width_m))
    if (world.name == name) return world;
  throw std::invalid_argument(name);
}

// Two visits to a place.
struct Visits {
  Pose2 world_from_first;
  Pose2 world_from_second;
  Grid first;
  Grid second;

  Visits(const IdealWorld& world, bool badly, RandomEngine& random)
      : world_from_first(any_visit(random)),
        world_from_second(any_visit(random)),
        first(seen_from_visit(world, world_from_first)),
        second(seen_from_visit(world, world_from_second)) {
    if (!badly) return;
    first = seen_badly(std::move(first), random);
    second = seen_badly(std::move(second), random);
  }
  Pose2 first_from_second() const { return inverse(world_from_first) * world_from_second; }
};

}  // namespace

//      |  |          |  |       |  |
//   ---+  |       ---+  +---    |  +---
//   ---------     ----------    +------
TEST_CASE("walls tell where a visit was, from a start off by much", "[metric][property]") {
  RandomEngine random(1);
  int off = 0;
  for (const char* const name : {"L", "T", "+"}) {
    for (int i = 0; i < 70; ++i) {
      const bool badly = i % 2 == 1;
      const Visits visits(world_named(name), badly, random);
      const PlaceWalls first(visits.first, walls_radius_m);
      const PlaceWalls second(visits.second, walls_radius_m);
      const Pose2 start = visits.first_from_second() * any_motion(0.7, 0.2, random);
      const WallFit fit = fit_walls(first, second, start, information_of_start);
      INFO(name << " " << i << " of " << first.pieces().size() << " pieces");
      off += apart_m(fit.first_from_second, visits.first_from_second()) < fine_m ? 0 : 1;
      CHECK(apart_m(fit.first_from_second, visits.first_from_second()) < 0.1);
      CHECK(apart_rad(fit.first_from_second, visits.first_from_second()) < fine_rad);
      CHECK(fit.matched_walls > (badly ? 0.85 : 0.97));
    }
  }
  // Now and then an L, from a start as far off as can be, ends a little beside.
  CHECK(off <= 3);
}

//   ------------
//   ------------
TEST_CASE("along a straight corridor the start is kept", "[metric][property]") {
  RandomEngine random(2);
  for (int i = 0; i < 60; ++i) {
    const Visits visits(world_named("corridor"), false, random);
    const PlaceWalls first(visits.first, walls_radius_m);
    const PlaceWalls second(visits.second, walls_radius_m);
    const Pose2 start = visits.first_from_second() * any_motion(0.5, 0.1, random);
    const WallFit fit = fit_walls(first, second, start, information_of_start);
    CHECK(apart_rad(fit.first_from_second, visits.first_from_second()) < fine_rad);
    const Point2 along = unit_vector(-visits.world_from_first.heading_rad);
    const Point2 off = fit.first_from_second.position() - visits.first_from_second().position();
    CHECK(std::abs(cross(along, off)) < fine_m);
    // A small turn about the start moves the frame along by little.
    CHECK(std::abs(dot(along, fit.first_from_second.position() - start.position())) < 0.08);

    const Matrix3 information = matrix(fit.information);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> moves(
        information.topLeftCorner<2, 2>().eval());
    CHECK(std::abs(moves.eigenvalues()[0]) < 1e-9 * moves.eigenvalues()[1]);
    const Point2 in_second = unit_vector(-visits.world_from_second.heading_rad);
    const Eigen::Vector2d ahead(in_second.x_m, in_second.y_m);
    // As far as the bits of walls drawn in cells are wrong in direction.
    CHECK(std::abs(ahead.dot(moves.eigenvectors().col(1))) < 0.15);
  }
}

// Most of a T is in a crossing too: the share tells them apart, by little.
TEST_CASE("another place has other walls", "[metric][property]") {
  RandomEngine random(3);
  const IdealWorld plus = world_named("+");
  for (const char* const name : {"L", "T", "dead end", "corridor"}) {
    for (int i = 0; i < 10; ++i) {
      const Visits visits(world_named(name), false, random);
      const PlaceWalls of_plus(seen_from_visit(plus, visits.world_from_first), walls_radius_m);
      const PlaceWalls first(visits.first, walls_radius_m);
      const PlaceWalls second(visits.second, walls_radius_m);
      const Pose2 start = visits.first_from_second();
      INFO(name);
      CHECK(fit_walls(of_plus, second, start, information_of_start).matched_walls + 0.01 <
            fit_walls(first, second, start, information_of_start).matched_walls);
      // Elsewhere altogether: a wall to the side of each corridor.
      const Pose2 aside = start * Pose2{1.2, 1.2, 0.7};
      CHECK(fit_walls(first, second, aside, diagonal(1e4, 1e5)).matched_walls < 0.6);
    }
  }
}

TEST_CASE("a fit moves with either frame", "[metric][property]") {
  RandomEngine random(4);
  for (int i = 0; i < 60; ++i) {
    const Visits visits(world_named(i % 2 == 0 ? "T" : "L"), true, random);
    const Pose2 start = visits.first_from_second() * any_motion(0.4, 0.1, random);
    // All walls count, wherever the frame's origin is.
    constexpr double all_m = 100;
    const PlaceWalls first(visits.first, all_m);
    const PlaceWalls second(visits.second, all_m);
    const WallFit fit = fit_walls(first, second, start, information_of_start);

    const Pose2 moved_from_first = any_motion(5, 3, random);
    const Pose2 moved_from_second = any_motion(5, 3, random);
    Grid moved_first = visits.first;
    moved_first.frame_from_grid = moved_from_first * moved_first.frame_from_grid;
    const WallFit one = fit_walls(PlaceWalls(moved_first, all_m), second, moved_from_first * start,
                                  information_of_start);
    // A piece on the border of two cells may fall to either.
    constexpr double little = 2e-3;
    CHECK(apart_m(one.first_from_second, moved_from_first * fit.first_from_second) < little);
    CHECK(apart_rad(one.first_from_second, moved_from_first * fit.first_from_second) < little);
    CHECK(one.matched_walls == Approx(fit.matched_walls).margin(0.01));

    Grid moved_second = visits.second;
    moved_second.frame_from_grid = moved_from_second * moved_second.frame_from_grid;
    const PoseCovariance of_start = [&] {
      Matrix3 motion;  // Ad(second_from_moved), column by column
      for (std::size_t column = 0; column < 3; ++column) {
        SmallMotion unit{};
        unit[column] = 1;
        const SmallMotion seen = seen_from(inverse(moved_from_second), unit);
        motion.col(Eigen::Index(column)) = Eigen::Map<const Eigen::Vector3d>(seen.data());
      }
      PoseCovariance result;
      Eigen::Map<Matrix3>{result.data()} =
          motion.transpose() * matrix(information_of_start) * motion;
      return result;
    }();
    const Pose2 second_from_moved = inverse(moved_from_second);
    const WallFit other =
        fit_walls(first, PlaceWalls(moved_second, all_m), start * second_from_moved, of_start);
    CHECK(apart_m(other.first_from_second * moved_from_second, fit.first_from_second) < little);
    CHECK(apart_rad(other.first_from_second * moved_from_second, fit.first_from_second) < little);
  }
}

TEST_CASE("the second fits the first as the first the second", "[metric][property]") {
  RandomEngine random(5);
  for (int i = 0; i < 60; ++i) {
    const Visits visits(world_named(i % 2 == 0 ? "T" : "+"), i % 4 < 2, random);
    const PlaceWalls first(visits.first, walls_radius_m);
    const PlaceWalls second(visits.second, walls_radius_m);
    const Pose2 start = visits.first_from_second() * any_motion(0.4, 0.1, random);
    const WallFit there = fit_walls(first, second, start, information_of_start);
    const WallFit back = fit_walls(second, first, inverse(start), information_of_start);
    CHECK(apart_m(inverse(back.first_from_second), there.first_from_second) < fine_m);
    CHECK(apart_rad(inverse(back.first_from_second), there.first_from_second) < fine_rad);
    CHECK(back.matched_walls == Approx(there.matched_walls).margin(0.02));
  }
}

// Where walls lie upon each other, no distance is weighed down: the sum is one of plain squares.
TEST_CASE("information is the curvature of the sum of squares", "[metric][property]") {
  RandomEngine random(6);
  constexpr WallFitOptions options;
  for (int i = 0; i < 20; ++i) {
    const Visits visits(world_named("T"), false, random);
    const PlaceWalls walls(visits.first, walls_radius_m);
    const WallFit fit = fit_walls(walls, walls, Pose2{}, information_of_start, options);
    CHECK(apart_m(fit.first_from_second, {}) < 1e-3);
    const auto sum = [&](double a, int row, double b, int column) {
      SmallMotion motion{};
      motion[static_cast<std::size_t>(row)] += a;
      motion[static_cast<std::size_t>(column)] += b;
      const Pose2 pose = exponential(motion);
      double squares = 0;
      for (const WallPiece& piece : walls.pieces()) {
        const WallPiece* const near = walls.nearest(piece.point);
        if (near == nullptr || std::abs(dot(near->normal, piece.normal)) < 0.8) continue;
        const double off = dot(near->normal, pose * piece.point - near->point) / options.wall_m;
        squares += off * off / 2;
      }
      return squares;
    };
    constexpr double step = 1e-4;
    const Matrix3 information = matrix(fit.information);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        const double curvature = (sum(step, row, step, column) - sum(step, row, -step, column) -
                                  sum(-step, row, step, column) + sum(-step, row, -step, column)) /
                                 (4 * step * step);
        CHECK(information(row, column) ==
              Approx(curvature).epsilon(0.02).margin(0.02 * information(row, row)));
      }
    }
  }
}

}  // namespace asterism
