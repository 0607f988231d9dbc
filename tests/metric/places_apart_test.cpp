#include "metric/places_apart.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "metric/layout.hpp"
#include "metric/layout_covariance.hpp"
#include "tests/metric/random_layout.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

constexpr double pi = std::numbers::pi;

Point2 any_point(double far_m, RandomEngine& random) {
  return between(0, far_m, random) * unit_vector(between(-pi, pi, random));
}

PlaneCovariance any_spread(RandomEngine& random) {
  const Point2 along = unit_vector(between(-pi, pi, random));
  const double wide = std::pow(10, between(-4, 1, random));
  const double narrow = wide * std::pow(10, between(-4, 0, random));
  return {wide * along.x_m * along.x_m + narrow * along.y_m * along.y_m,
          (wide - narrow) * along.x_m * along.y_m,
          wide * along.y_m * along.y_m + narrow * along.x_m * along.x_m};
}

/// By trying out the circle, ever finer.
double misfit_by_trial(Point2 point, const PlaneCovariance& spread, double least_m) {
  Eigen::Matrix2d covariance;
  covariance << spread.xx, spread.xy, spread.xy, spread.yy;
  const Eigen::Matrix2d information = covariance.inverse();
  const auto at = [&](double angle_rad) {
    const Point2 off = least_m * unit_vector(angle_rad) - point;
    const Eigen::Vector2d error(off.x_m, off.y_m);
    return error.dot(information * error);
  };
  double best_rad = 0;
  constexpr int steps = 4000;
  double width_rad = 2 * pi / steps;
  for (int i = 0; i < steps; ++i)
    if (at(i * width_rad) < at(best_rad)) best_rad = i * width_rad;
  for (; width_rad > 1e-12; width_rad /= 2)
    for (const double angle_rad : {best_rad - width_rad, best_rad + width_rad})
      if (at(angle_rad) < at(best_rad)) best_rad = angle_rad;
  return at(best_rad);
}

/// One map of places and discs, told in another order of places.
struct Told {
  std::vector<Pose2> poses;
  std::vector<PlaceDisplacement> displacements;
  std::vector<std::optional<PlaceDisc>> discs;
};

Told reordered(const Told& told, const std::vector<std::size_t>& new_number) {
  Told result = told;
  for (std::size_t i = 0; i < told.poses.size(); ++i) {
    result.poses[new_number[i]] = told.poses[i];
    result.discs[new_number[i]] = told.discs[i];
  }
  for (PlaceDisplacement& each : result.displacements) {
    each.from = PlaceId(new_number[each.from.index()]);
    each.to = PlaceId(new_number[each.to.index()]);
  }
  const Pose2 first_from_layout = inverse(result.poses.front());
  for (Pose2& pose : result.poses) pose = first_from_layout * pose;
  return result;
}

Told mirrored(Told told) {
  const auto flip = [](auto& pose) {
    pose.y_m = -pose.y_m;
    pose.heading_rad = -pose.heading_rad;
  };
  for (Pose2& pose : told.poses) flip(pose);
  for (auto& disc : told.discs) disc->middle.y_m = -disc->middle.y_m;
  for (PlaceDisplacement& each : told.displacements) {
    flip(each.displacement);
    for (const std::size_t i : {1U, 2U, 3U, 6U})
      each.displacement.covariance[i] = -each.displacement.covariance[i];
  }
  return told;
}

std::vector<SharedSpot> spots(const Told& told) {
  return shared_spots(told.poses, told.displacements, told.discs, 1e-3);
}

}  // namespace

TEST_CASE("how far off a point is from lying apart is what trying out the circle says",
          "[metric][property]") {
  RandomEngine random(1);
  int hard = 0;
  for (int i = 0; i < 3000; ++i) {
    const double least_m = between(0.1, 5, random);
    const PlaneCovariance spread = any_spread(random);
    Point2 point = any_point(0.999 * least_m, random);
    if (i % 5 == 0) {  // with nothing along the direction that is least certain
      const Point2 along = spread.along();
      point = dot(left_of(along), point) * left_of(along);
      ++hard;
    }
    if (i % 50 == 0) point = {};
    const double by_trial = misfit_by_trial(point, spread, least_m);
    CAPTURE(i, least_m, spread.xx, spread.xy, spread.yy, point.x_m, point.y_m);
    CHECK(misfit_of_lying_apart(point, spread, least_m) == Approx(by_trial).epsilon(1e-4));
  }
  CHECK(hard > 500);
  CHECK(misfit_of_lying_apart({3, 4}, {1, 0, 1}, 5) == 0);
  CHECK(misfit_of_lying_apart({0, 0}, {4, 0, 1}, 6) == Approx(9));
}

TEST_CASE("one place sees another as well, whichever place the layout hangs from",
          "[metric][property]") {
  RandomEngine random(2);
  for (std::size_t i = 0; i < 200; ++i) {
    const std::size_t places = 2 + i % 7;
    RandomLayout world = random_layout(places, places + i % 5, 0.1, random);
    Told told{lay_out(places, world.displacements).layout_from_place, world.displacements, {}};
    for (std::size_t k = 0; k < places; ++k)
      told.discs.push_back(PlaceDisc{any_point(2, random), 1});
    std::vector<std::size_t> order(places);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::rotate(order.begin(), order.begin() + 1, order.end());
    const Told other = reordered(told, order);
    const LayoutCovariance covariance(told.poses, told.displacements);
    const LayoutCovariance of_other(other.poses, other.displacements);
    const auto seen = [&](const LayoutCovariance& by, const Told& in, std::size_t a,
                          std::size_t b) {
      const PlaneCovariance spread =
          by.seen_from({PlaceId(a), in.discs[a]->middle}, {PlaceId(b), in.discs[b]->middle});
      // Along the axes of the place that looks.
      const Point2 ahead = unit_vector(in.poses[a].heading_rad);
      const Eigen::Vector2d x(ahead.x_m, ahead.y_m), y(-ahead.y_m, ahead.x_m);
      Eigen::Matrix2d matrix;
      matrix << spread.xx, spread.xy, spread.xy, spread.yy;
      return Eigen::Vector3d(x.dot(matrix * x), x.dot(matrix * y), y.dot(matrix * y));
    };
    const Eigen::Vector3d one = seen(covariance, told, 0, places - 1);
    const Eigen::Vector3d same = seen(of_other, other, order[0], order[places - 1]);
    CHECK((one - same).norm() < 1e-6 * one.norm());
    // From the place that all hangs from, the others are as certain as they are laid out.
    const PoseCovariance last = covariance.of_places().back();
    const Eigen::Vector3d point_only = seen(
        covariance, {told.poses, {}, std::vector<std::optional<PlaceDisc>>(places, PlaceDisc{})}, 0,
        places - 1);
    const double trace = last[0] + last[4];
    CHECK(point_only[0] + point_only[2] == Approx(trace));
  }
}

TEST_CASE("places on one spot are the same in any order, and mirrored", "[metric][property]") {
  RandomEngine random(3);
  std::size_t found = 0;
  std::size_t apart = 0;
  for (std::size_t i = 0; i < 1500; ++i) {
    const std::size_t places = 3 + i % 8;
    RandomLayout world = random_layout(places, places - 1 + i % 4, 0.02, random);
    Told told{lay_out(places, world.displacements).layout_from_place, world.displacements, {}};
    for (std::size_t k = 0; k < places; ++k)
      told.discs.push_back(PlaceDisc{any_point(1, random), between(0, 2.5, random)});
    std::vector<std::size_t> order(places);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::shuffle(order, random);
    const auto before = spots(told);
    auto after = spots(reordered(told, order));
    found += before.size();
    apart += places * (places - 1) / 2 - before.size();
    REQUIRE(after.size() == before.size());
    CHECK(spots(mirrored(told)).size() == before.size());
    for (const SharedSpot& spot : before) {
      const auto [one, other] = std::minmax(order[spot.one.index()], order[spot.other.index()]);
      const auto same = std::ranges::find_if(after, [&](const SharedSpot& each) {
        return each.one.index() == one && each.other.index() == other;
      });
      REQUIRE(same != after.end());
      CHECK(same->distance_m == Approx(spot.distance_m));
      CHECK(same->misfit.chi_squared == Approx(spot.misfit.chi_squared).epsilon(1e-4));
    }
  }
  CHECK(found > 100);
  CHECK(apart > 100);
}

TEST_CASE("a place takes up the disc that reaches its nearest gateway", "[metric]") {
  Visit visit{.star = Star::parse("a+1 b+1 a-1 b-0")};
  CHECK_FALSE(disc_of(visit));
  visit.gateways = {{"a+", 3, 0, 0, 1}, {"b+", 0, -1, 0, 1}, {"a-", -3, 1, 0, 1}};
  CHECK(norm(disc_of(visit)->middle) < 1e-12);
  CHECK(disc_of(visit)->radius_m == 1);
}

TEST_CASE("only what is certain to overlap lies on one spot", "[metric]") {
  const auto spots_of = [](double apart_m, double deviation_m) {
    const Displacement d =
        make_displacement({apart_m, 0, 0}, diagonal(deviation_m * deviation_m, 1e-4));
    const std::vector<Pose2> poses{{}, {apart_m, 0, 0}};
    const std::vector<PlaceDisplacement> displacements{{PlaceId(0), PlaceId(1), d}};
    const std::vector<std::optional<PlaceDisc>> discs(2, PlaceDisc{{}, 1});
    return shared_spots(poses, displacements, discs, 1e-3).size();
  };
  CHECK(spots_of(0.02, 0.1) == 1);
  CHECK(spots_of(1.0, 0.1) == 1);  // 0.7 m too near, at 0.1 m
  CHECK(spots_of(1.0, 0.5) == 0);  // ... at 0.5 m
  CHECK(spots_of(1.69, 0.001) == 1);
  CHECK(spots_of(1.71, 0.001) == 0);
}

}  // namespace asterism
