#include "metric/ranking.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

#include "engine/tree/map_tree.hpp"
#include "metric/alignment.hpp"
#include "metric/chi_squared.hpp"
#include "metric/exponential.hpp"
#include "metric/layout.hpp"
#include "metric/layout_residual.hpp"
#include "metric/places_apart.hpp"
#include "tests/metric/measured_walk.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

MapTree tree_of(const Trace& trace, bool planar = false) {
  MapTree tree({.planar = planar});
  tree.extend(trace.visits);
  return tree;
}

struct Ranked {
  std::vector<RankedMap> maps;
  std::size_t layouts = 0;
};

Ranked ranked(const MapTree& tree, const AlignmentSource& alignments,
              const RankingOptions& options) {
  const auto classes = tree.by_preference();
  Ranking ranking(tree.trace(), alignments, options);
  for (const auto& hypotheses : classes) {
    if (ranking.is_settled()) break;
    ranking.add([&](const auto& f) {
      tree.for_each(hypotheses, [&](HypothesisId, std::span<const Arrival> map) { f(map); });
    });
  }
  Ranked result{ranking.best(), 0};
  result.layouts = ranking.layouts();
  return result;
}

// By gateways, which are exact, so that no alignment is better known than another.
AlignmentSource exact(PlaceAlignments& alignments) {
  return [&](VisitId first, VisitId visit, std::size_t entered) {
    Alignment alignment = alignments(first, visit, entered);
    alignment.covariance = {};
    alignment.misfit = {};
    return alignment;
  };
}

// What does not depend on how places are numbered.
using Sums = std::vector<std::array<double, 4>>;

Sums sums(const Trace& trace, std::size_t models) {
  PlaceAlignments alignments(trace, {});
  const MapTree tree = tree_of(trace);
  Sums result;
  for (const RankedMap& map : ranked(tree, exact(alignments), {.models = models}).maps)
    if (map.is_plausible)
      result.push_back({static_cast<double>(map.map.paths.size()),
                        static_cast<double>(map.map.places.size()), map.misfit.chi_squared,
                        map.log_likelihood});
  return result;
}

// λ = L d L'⁻¹ by the definition of its covariance: each error is tried out alone.
Displacement compounded(const Pose2& left, const PoseCovariance& of_left, const Displacement& d,
                        const Pose2& reached, const PoseCovariance& of_reached) {
  const auto whole = [&](const SmallMotion& a, const SmallMotion& b, const SmallMotion& c) {
    return left * exponential(a) * d.left_from_reached() * exponential(b) *
           inverse(reached * exponential(c));
  };
  const Pose2 mean = whole({}, {}, {});
  PoseCovariance covariance{};
  constexpr double step = 1e-6;
  for (std::size_t part = 0; part < 3; ++part) {
    const PoseCovariance of_part = std::array{of_left, d.covariance, of_reached}[part];
    std::array<SmallMotion, 3> slope{};
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<SmallMotion, 3> errors{};
      errors[part][i] = step;
      slope[i] = logarithm(inverse(mean) * whole(errors[0], errors[1], errors[2]));
    }
    for (std::size_t i = 0; i < 9; ++i)
      for (std::size_t k = 0; k < 9; ++k)
        covariance[i] += slope[k / 3][i / 3] * slope[k % 3][i % 3] * of_part[k] / (step * step);
  }
  for (const std::size_t i : {1U, 2U, 5U}) {
    const std::size_t mirrored = 3 * (i % 3) + i / 3;
    covariance[i] = covariance[mirrored] = (covariance[i] + covariance[mirrored]) / 2;
  }
  return make_displacement(mean, covariance);
}

// How a place sees a point of another: less the middle of its own gateways, in its own frame.
Eigen::Vector2d seen(const std::vector<Pose2>& poses, const Trace& trace, const TopologicalMap& map,
                     std::size_t one, std::size_t other) {
  const auto middle = [&](std::size_t place) {
    const auto& gateways = trace.visits[map.places[place].first_visit.index()].gateways;
    Point2 sum;
    for (const MeasuredGateway& gateway : gateways) sum = sum + gateway.middle();
    return 1 / static_cast<double>(gateways.size()) * sum;
  };
  const Point2 at = inverse(poses[one]) * (poses[other] * middle(other)) - middle(one);
  return {at.x_m, at.y_m};
}

double radius_m(const Trace& trace, const TopologicalMap& map, std::size_t place) {
  return disc_of(trace.visits[map.places[place].first_visit.index()])->radius_m;
}

/// Whether two places lie on one spot, by slopes that are tried out and a full inverse.
bool is_crowded(const Trace& trace, const RankedMap& ranked) {
  const std::vector<Pose2>& poses = ranked.layout.layout_from_place;
  if (poses.size() < 2) return false;
  const auto size = static_cast<Eigen::Index>(3 * (poses.size() - 1));
  constexpr double step = 1e-5;
  const auto moved = [&](Eigen::Index i, double by) {
    std::vector<Pose2> result = poses;
    Pose2& pose = result[static_cast<std::size_t>(i / 3) + 1];
    (i % 3 == 0 ? pose.x_m : i % 3 == 1 ? pose.y_m : pose.heading_rad) += by;
    return result;
  };
  Eigen::MatrixXd curvature = Eigen::MatrixXd::Zero(size, size);
  for (const PlaceDisplacement& travel : ranked.displacements) {
    const LayoutResidual residual(travel.displacement);
    const auto at = [&](const std::vector<Pose2>& where) {
      return residual(where[travel.from.index()], where[travel.to.index()]).residual;
    };
    Eigen::MatrixXd slope(3, size);
    for (Eigen::Index i = 0; i < size; ++i)
      slope.col(i) = (at(moved(i, step)) - at(moved(i, -step))) / (2 * step);
    curvature += slope.transpose() * slope;
  }
  const Eigen::MatrixXd covariance = curvature.inverse();
  const auto misfit = [&](std::size_t one, std::size_t other) {
    const double least_m =
        radius_m(trace, ranked.map, one) + radius_m(trace, ranked.map, other) - 0.3;
    const Eigen::Vector2d point = seen(poses, trace, ranked.map, one, other);
    if (point.norm() >= least_m) return 0.0;
    Eigen::MatrixXd slope(2, size);
    for (Eigen::Index i = 0; i < size; ++i)
      slope.col(i) = (seen(moved(i, step), trace, ranked.map, one, other) -
                      seen(moved(i, -step), trace, ranked.map, one, other)) /
                     (2 * step);
    const Eigen::Matrix2d information = (slope * covariance * slope.transpose()).inverse();
    double least = 1e300;
    for (int i = 0; i < 20'000; ++i) {
      const Point2 on_circle = least_m * unit_vector(i * 2 * std::numbers::pi / 20'000);
      const Eigen::Vector2d off = Eigen::Vector2d(on_circle.x_m, on_circle.y_m) - point;
      least = std::min(least, off.dot(information * off));
    }
    return least;
  };
  for (std::size_t j = 0; j < poses.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      if (chi_squared_tail(std::min(misfit(i, j), misfit(j, i)), 1) < 1e-3) return true;
  return false;
}

// One hypothesis by itself, nothing shared and nothing begun from elsewhere.
RankedMap ranked_alone(const Trace& trace, const AlignmentSource& source, TopologicalMap map) {
  RankedMap result{.map = std::move(map)};
  std::vector<Pose2> in_place;
  std::vector<PoseCovariance> covariances;
  double misfit = 0;
  for (std::size_t k = 0; k < result.map.visits.size(); ++k) {
    const PlaceId place = result.map.visits[k];
    const VisitId first = result.map.places[place.index()].first_visit;
    in_place.emplace_back();
    covariances.emplace_back();
    if (first.index() != k) {
      const Alignment alignment = source(first, VisitId(k), result.map.entered[k].value());
      in_place[k] = alignment.place_from_visit;
      covariances[k] = alignment.covariance;
      misfit += alignment.misfit.chi_squared;
      result.alignments.push_back(alignment);
      if (alignment.misfit.tail_probability < 1e-3) result.is_plausible = false;
    }
    if (k == 0) continue;
    result.displacements.push_back(
        {result.map.visits[k - 1], place,
         compounded(in_place[k - 1], covariances[k - 1], *trace.visits[k].displacement, in_place[k],
                    covariances[k])});
  }
  result.layout = lay_out(result.map.places.size(), result.displacements);
  const std::size_t degrees = 3 * (result.map.visits.size() - result.map.places.size());
  result.misfit = {result.layout.chi_squared, degrees,
                   chi_squared_tail(result.layout.chi_squared, degrees)};
  if (result.misfit.tail_probability < 1e-3) result.is_plausible = false;
  if (result.is_plausible && is_crowded(trace, result)) {
    result.is_plausible = false;
    result.shared_spots = {{PlaceId(0), PlaceId(1)}};  // some
  }
  result.log_likelihood = -(result.layout.chi_squared + misfit) / 2;
  return result;
}

/// 0: none, 1: it fits, but places share a spot, 2: it does not fit.
int doubt_of(const RankedMap& ranked) {
  if (ranked.is_plausible) return 0;
  const bool fits = ranked.misfit.tail_probability >= 1e-3 &&
                    std::ranges::all_of(ranked.alignments, [](const Alignment& alignment) {
                      return alignment.misfit.tail_probability >= 1e-3;
                    });
  return fits && !ranked.shared_spots.empty() ? 1 : 2;
}

void check_same(const Sums& a, const Sums& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < a[i].size(); ++k)
      CHECK(a[i][k] == Approx(b[i][k]).epsilon(1e-6).margin(1e-6));
}

}  // namespace

TEST_CASE("the true map ranks first where measures are honest", "[metric][property]") {
  RandomEngine random(1);
  constexpr int walks = 150;
  int first = 0;
  int plausible = 0;
  int several = 0;
  for (int i = 0; i < walks; ++i) {
    const MeasuredWalk walk = measured_walk(8 + below(8, random), 0.3, random);
    PlaceAlignments alignments(walk.trace, {});
    const MapTree tree = tree_of(walk.trace);
    const auto best = ranked(tree, exact(alignments), {.models = 1}).maps;
    REQUIRE(best.size() == 1);
    first += arrivals(best[0].map) == walk.truth ? 1 : 0;
    plausible += best[0].is_plausible ? 1 : 0;
    several += tree.minimal().size() > 1 ? 1 : 0;
  }
  // One in a thousand true layouts is called implausible.
  CHECK(first >= walks - 2);
  CHECK(plausible >= walks - 1);
  CHECK(several > walks / 4);
}

TEST_CASE("ranking is that of every hypothesis laid out from scratch",
          "[metric][reference][property]") {
  RandomEngine random(2);
  std::size_t implausible = 0;
  std::size_t crowded = 0;
  for (int i = 0; i < 240; ++i) {
    // Every other walk is measured so badly that most maps are plausible.
    const MeasuredWalk walk = measured_walk(6 + below(4, random), i % 2 == 0 ? 0.2 : 3, random);
    PlaceAlignments alignments(walk.trace, {});
    const MapTree tree = tree_of(walk.trace);
    const AlignmentSource source = std::ref(alignments);
    const std::size_t models = 1 + below(12, random);
    const auto best = ranked(tree, source, {.models = models}).maps;

    using Key = std::tuple<int, std::size_t, std::size_t, double>;
    std::vector<Key> keys;
    tree.for_each([&](HypothesisId id, std::span<const Arrival>) {
      const RankedMap whole = ranked_alone(walk.trace, source, tree.map(id));
      keys.emplace_back(doubt_of(whole), whole.map.paths.size(), whole.map.places.size(),
                        -whole.log_likelihood);
    });
    std::ranges::sort(keys);
    REQUIRE(best.size() == std::min<std::size_t>(models, tree.size()));
    for (std::size_t k = 0; k < best.size(); ++k) {
      CHECK(std::get<0>(keys[k]) == doubt_of(best[k]));
      CHECK(std::get<1>(keys[k]) == best[k].map.paths.size());
      CHECK(std::get<2>(keys[k]) == best[k].map.places.size());
      // Far from any fit, a sum of squares has many minima: which is found is chance.
      if (best[k].is_plausible)
        CHECK(std::get<3>(keys[k]) == Approx(-best[k].log_likelihood).epsilon(1e-5).margin(1e-6));
      implausible += best[k].is_plausible ? 0U : 1U;
      crowded += best[k].shared_spots.empty() ? 0U : 1U;
      CHECK(best[k].shared_spots.empty() == !is_crowded(walk.trace, best[k]));
    }
  }
  CHECK(implausible > 20);
  CHECK(crowded > 3);
}

TEST_CASE("a trace backwards, mirrored or turned ranks the same", "[metric][property]") {
  RandomEngine random(3);
  std::size_t compared = 0;
  for (int i = 0; i < 60; ++i) {
    const Trace trace = measured_walk(7 + below(5, random), i % 2 == 0 ? 0.3 : 2, random).trace;
    const Sums there = sums(trace, 6);
    compared += there.size();
    check_same(sums(measured_backwards(trace), 6), there);
    check_same(sums(measured_in_mirror(trace), 6), there);
    check_same(sums(measured_turned(trace, between(-3, 3, random)), 6), there);
  }
  CHECK(compared > 100);
}

//   o--o--o--o   walks through a large grid: very many maps, few of them laid out
TEST_CASE("the best of very many hypotheses takes few layouts", "[metric]") {
  RandomEngine random(5);
  std::uint64_t most = 0;
  for (int i = 0; i < 20; ++i) {
    const MeasuredWalk walk = measured_walk(22, 0.2, random, 8);
    MapTree tree({.max_hypotheses = 2'000'000});
    if (tree.extend(walk.trace.visits) != MapTree::Growth::complete) continue;
    PlaceAlignments alignments(walk.trace, {});
    most = std::max(most, tree.size());
    // Of maps whose places lie apart there are fewer: one has to look further for ten.
    for (const bool on_one_floor : {false, true}) {
      const Ranked best =
          ranked(tree, std::ref(alignments), {.models = 10, .on_one_floor = on_one_floor});
      INFO(tree.size() << " maps, " << best.layouts << " layouts");
      CHECK(best.layouts < (on_one_floor ? 6'000 : 3'000));
      CHECK(arrivals(best.maps.front().map) == walk.truth);
    }
  }
  CHECK(most > 100'000);
}

TEST_CASE("a layout is its parent's where nothing closed", "[metric][property]") {
  RandomEngine random(6);
  int opened = 0;
  for (int i = 0; i < 40; ++i) {
    const MeasuredWalk walk = measured_walk(9, 0.3, random);
    PlaceAlignments alignments(walk.trace, {});
    const AlignmentSource source = std::ref(alignments);
    Trace shorter = walk.trace;
    shorter.visits.pop_back();
    shorter.visits.back().left_by.reset();
    std::vector<Arrival> truth = walk.truth;
    const bool is_new = std::ranges::none_of(
        truth.begin(), truth.end() - 1,
        [&](const Arrival& arrival) { return arrival.place == walk.truth.back().place; });
    if (!is_new) continue;
    ++opened;
    truth.pop_back();
    const RankedMap child = ranked_alone(walk.trace, source, make_map(walk.trace, walk.truth));
    const RankedMap parent = ranked_alone(shorter, source, make_map(shorter, truth));
    CHECK(child.misfit.chi_squared == Approx(parent.misfit.chi_squared).epsilon(1e-7).margin(1e-9));
    for (std::size_t p = 0; p < parent.map.places.size(); ++p) {
      const Pose2& a = parent.layout.layout_from_place[p];
      const Pose2& b = child.layout.layout_from_place[p];
      CHECK(norm(a.position() - b.position()) < 1e-6);
      CHECK(std::abs(wrapped(a.heading_rad - b.heading_rad)) < 1e-6);
    }
  }
  CHECK(opened > 5);
}

TEST_CASE("where no map is asked for none is ranked", "[metric]") {
  RandomEngine random(8);
  const MeasuredWalk walk = measured_walk(6, 0.3, random);
  PlaceAlignments alignments(walk.trace, {});
  const MapTree tree = tree_of(walk.trace);
  Ranking ranking(walk.trace, std::ref(alignments), {.models = 0});
  ranking.add([&](const auto& f) {
    tree.for_each([&](HypothesisId, std::span<const Arrival> map) { f(map); });
  });
  CHECK(ranking.best().empty());
  CHECK(ranking.most_preferred().empty());
  CHECK(ranking.layouts() == 0);
}

TEST_CASE("what has no displacement cannot be ranked", "[metric]") {
  RandomEngine random(7);
  Trace trace = measured_walk(4, 0.3, random).trace;
  PlaceAlignments alignments(trace, {});
  trace.visits[2].displacement->covariance = {};
  CHECK_THROWS_AS(Ranking(trace, std::ref(alignments)), std::invalid_argument);
  trace.visits[2].displacement.reset();
  CHECK_THROWS_AS(Ranking(trace, std::ref(alignments)), std::invalid_argument);
}

}  // namespace asterism
