#include "metric/alignment.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include "metric/exponential.hpp"
#include "tests/metric/measured_walk.hpp"
#include "tests/metric/seen_place.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

constexpr double quarter_rad = std::numbers::pi / 2;
constexpr double fine_m = 0.03;
constexpr double fine_rad = 0.01;

IdealWorld crossing() { return ideal_worlds(2)[2]; }

// A visit to the crossing, by the arm that leads along +x; arms go clockwise.
Visit visit_of_crossing(const Pose2& world_from_visit) {
  Visit visit{.star = Star::parse(crossing().star), .entered_by = 0};
  for (std::size_t arm = 0; arm < 4; ++arm) {
    const double heading_rad = -quarter_rad * static_cast<double>(arm);
    const Point2 middle = 2.0 * unit_vector(heading_rad);
    const Pose2 seen = inverse(world_from_visit) * Pose2{middle.x_m, middle.y_m, heading_rad};
    visit.gateways.push_back({visit.star.name(arm), seen.x_m, seen.y_m, seen.heading_rad, 2});
  }
  return visit;
}

struct Crossing {
  std::vector<Pose2> world_from_visit;
  Trace trace;
  std::vector<std::optional<Grid>> maps;

  Crossing(std::size_t visits, RandomEngine& random) {
    for (std::size_t k = 0; k < visits; ++k) {
      world_from_visit.push_back(any_visit(random));
      trace.visits.push_back(visit_of_crossing(world_from_visit.back()));
      maps.emplace_back(seen_from_visit(crossing(), world_from_visit.back()));
    }
  }
  // Where the hypothesis puts a visit that it has come in by another arm.
  Pose2 expected(std::size_t first, std::size_t visit, std::size_t entered) const {
    const Pose2 turn{0, 0, wrapped(-quarter_rad * static_cast<double>(entered))};
    return inverse(world_from_visit[first]) * turn * world_from_visit[visit];
  }
};

void check_pose(const Pose2& found, const Pose2& expected, double most_m, double most_rad) {
  CHECK(norm(found.position() - expected.position()) < most_m);
  CHECK(std::abs(wrapped(found.heading_rad - expected.heading_rad)) < most_rad);
}

}  // namespace

//      |  |
//   ---+  +---     by its walls alone, a crossing looks the same four ways
//   ---+  +---
//      |  |
TEST_CASE("an alignment is the one that the hypothesis says", "[metric][property]") {
  RandomEngine random(1);
  for (int i = 0; i < 25; ++i) {
    const Crossing place(2, random);
    for (const bool walls : {false, true}) {
      PlaceAlignments alignments(place.trace,
                                 walls ? place.maps : std::vector<std::optional<Grid>>{});
      for (std::size_t entered = 0; entered < 4; ++entered) {
        const Alignment& found = alignments(VisitId(0), VisitId(1), entered);
        CHECK(found.visit == VisitId(1));
        check_pose(found.place_from_visit, place.expected(0, 1, entered), walls ? fine_m : 1e-6,
                   walls ? fine_rad : 1e-6);
        CHECK(found.misfit.degrees_of_freedom == (walls ? 12U : 9U));
        CHECK(found.misfit.tail_probability > 0.99);
        CHECK(is_covariance(found.covariance));
        CHECK((walls ? found.matched_walls > 0.95 : found.matched_walls == 0));
      }
    }
  }
}

TEST_CASE("gateways that are off are put right by walls", "[metric][property]") {
  RandomEngine random(2);
  const AlignmentOptions options;
  double by_gateways_m = 0;
  for (int i = 0; i < 40; ++i) {
    Crossing place(2, random);
    for (MeasuredGateway& gateway : place.trace.visits[1].gateways) {
      gateway.x_m += options.aside_m * normal(random);
      gateway.y_m += options.aside_m * normal(random);
      gateway.heading_rad = wrapped(gateway.heading_rad + options.heading_rad * normal(random));
    }
    PlaceAlignments alone(place.trace, {});
    PlaceAlignments both(place.trace, place.maps);
    const Alignment& rough = alone(VisitId(0), VisitId(1), 0);
    const Alignment& fine = both(VisitId(0), VisitId(1), 0);
    by_gateways_m +=
        norm(rough.place_from_visit.position() - place.expected(0, 1, 0).position()) / 40;
    check_pose(fine.place_from_visit, place.expected(0, 1, 0), fine_m, fine_rad);
    for (const std::size_t at : {0U, 4U, 8U}) CHECK(fine.covariance[at] < rough.covariance[at]);
    CHECK(fine.misfit.chi_squared > rough.misfit.chi_squared);
  }
  CHECK(by_gateways_m > 2 * fine_m);
}

TEST_CASE("exact gateways tell the pose of every return", "[metric][property]") {
  RandomEngine random(3);
  std::size_t returns = 0;
  for (int i = 0; i < 60; ++i) {
    const MeasuredWalk walk = measured_walk(12, 0.3, random);
    PlaceAlignments alignments(walk.trace, {});
    const TopologicalMap map = make_map(walk.trace, walk.truth);
    for (std::size_t k = 1; k < walk.truth.size(); ++k) {
      const VisitId first = map.places[walk.truth[k].place.index()].first_visit;
      if (first.index() == k) continue;
      const Alignment& found = alignments(first, VisitId(k), walk.truth[k].entered.value());
      // One gateway, known only so well, is enough where it is exact.
      check_pose(found.place_from_visit,
                 inverse(walk.world_from_visit[first.index()]) * walk.world_from_visit[k], 1e-6,
                 1e-6);
      CHECK(found.misfit.chi_squared < 1e-9);
      ++returns;
    }
  }
  CHECK(returns > 100);
}

TEST_CASE("without a gateway in common little is known", "[metric]") {
  RandomEngine random(4);
  Crossing place(2, random);
  auto& first = place.trace.visits[0].gateways;
  auto& second = place.trace.visits[1].gateways;
  first.erase(first.begin() + 2, first.end());
  second.erase(second.begin(), second.begin() + 2);
  PlaceAlignments alignments(place.trace, place.maps);
  const Alignment& none = alignments(VisitId(0), VisitId(1), 0);
  CHECK(none.covariance[0] >= 1);
  CHECK(none.covariance[4] >= 1);
  CHECK(none.covariance[8] >= 0.5);
  CHECK(none.misfit.degrees_of_freedom == 0);
  CHECK(none.misfit.tail_probability == 1);
  // Entered by the opposite arm, the gateways are the same ones.
  const Alignment& common = alignments(VisitId(0), VisitId(1), 2);
  CHECK(common.misfit.degrees_of_freedom == 6);
  check_pose(common.place_from_visit, place.expected(0, 1, 2), fine_m, fine_rad);
}

TEST_CASE("what was asked before does not show", "[metric][property]") {
  RandomEngine random(5);
  for (int i = 0; i < 5; ++i) {
    const Crossing place(3, random);
    PlaceAlignments all(place.trace, place.maps);
    for (int again = 0; again < 2; ++again) {
      for (std::size_t visit = 1; visit < 3; ++visit) {
        for (std::size_t entered = 0; entered < 4; ++entered) {
          PlaceAlignments fresh(place.trace, place.maps);
          const Alignment& a = all(VisitId(0), VisitId(visit), entered);
          const Alignment& b = fresh(VisitId(0), VisitId(visit), entered);
          CHECK(a.place_from_visit == b.place_from_visit);
          CHECK(a.covariance == b.covariance);
          CHECK(a.misfit.chi_squared == b.misfit.chi_squared);
          CHECK(a.matched_walls == b.matched_walls);
        }
      }
    }
  }
}

}  // namespace asterism
