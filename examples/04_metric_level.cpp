// The metric level in one page: a robot drives one and a half times round a ring of four corners
// that all look alike. Which ring is it? The axioms allow any number of corners from two up, and
// preference takes the fewest; how far it drove tells.

#include <cstdlib>
#include <iomanip>
#include <iostream>

#include "engine/tree/map_tree.hpp"
#include "io/json/trace_file.hpp"
#include "metric/ranking.hpp"

using namespace asterism;

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: example_04_metric_level TRACE\n";
    return EXIT_FAILURE;
  }
  const Trace trace = read_trace_file(argv[1]);
  MapTree tree;
  tree.extend(trace.visits);
  std::cout << tree.size() << " maps explain the trace\n";

  // Back at a place, the robot stands where it stood, within 0.1 m and 0.02 rad. With place maps at
  // hand, PlaceAlignments measures where.
  const auto as_before = [](VisitId first, VisitId visit, std::size_t) {
    return Alignment{.visit = visit,
                     .place = PlaceId(first.index()),
                     .covariance = {0.01, 0, 0, 0, 0.01, 0, 0, 0, 0.0004}};
  };
  Ranking ranking(trace, as_before, {.models = 3});
  for (const auto& equally_preferred : tree.by_preference()) {
    ranking.add([&tree, equally_preferred](const auto& rank) {
      tree.for_each(equally_preferred,
                    [&](HypothesisId, std::span<const Arrival> map) { rank(map); });
    });
    if (ranking.is_settled()) break;
  }

  std::cout << std::fixed << std::setprecision(1);
  const std::vector<RankedMap> models = ranking.best();
  for (const RankedMap& model : models) {
    std::cout << model.map.places.size() << " places, "
              << (model.is_plausible ? "plausible" : "implausible") << ": chi-squared "
              << model.misfit.chi_squared << " of " << model.misfit.degrees_of_freedom
              << " degrees of freedom\n";
  }

  std::cout << "layout of the first, in metres:\n";
  const Layout& layout = models.front().layout;
  for (std::size_t p = 0; p < layout.layout_from_place.size(); ++p) {
    const Pose2& pose = layout.layout_from_place[p];
    std::cout << "  place " << p << " at " << pose.x_m << ", " << pose.y_m << '\n';
  }
  return EXIT_SUCCESS;
}
