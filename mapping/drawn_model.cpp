#include "mapping/drawn_model.hpp"

#include <cstddef>
#include <exception>
#include <utility>

#include "metric/global_map.hpp"
#include "metric/refinement.hpp"

namespace asterism {
namespace {

/// Where each visit was, by the layout: [x_{i,0}]_{m*} = χ ⊕ L_i. Visits that the map does not
/// explain follow by displacement alone.                              [BMK10, §7.3.3] [theory §12]
std::vector<Anchor> anchors(const Trace& trace, const RankedMap& ranked) {
  std::vector<Pose2> layout_from_visit;
  for (const PlaceId place : ranked.map.visits)
    layout_from_visit.push_back(ranked.layout.layout_from_place[place.index()]);
  for (const Alignment& alignment : ranked.alignments) {
    Pose2& visit = layout_from_visit[alignment.visit.index()];
    visit = visit * alignment.place_from_visit;
  }
  std::vector<Anchor> result;
  for (std::size_t k = 0; k < trace.visits.size(); ++k) {
    if (k == layout_from_visit.size())
      layout_from_visit.push_back(layout_from_visit.back() *
                                  trace.visits[k].displacement->left_from_reached());
    result.push_back(
        {static_cast<std::size_t>(trace.visits[k].scans.value()[0]), layout_from_visit[k]});
  }
  return result;
}

}  // namespace

std::vector<DrawnModel> draw_models(const Perceived& perceived, std::vector<RankedMap> ranked,
                                    double resolution_m) {
  Refinement refined(perceived.scans, perceived.poses);
  std::vector<DrawnModel> models;
  for (RankedMap& map : ranked) {
    DrawnModel model{std::move(map)};
    try {
      model.trajectory = fit_trajectory(perceived.poses, anchors(perceived.trace, model.ranked));
      if (models.empty()) model.trajectory = refined(model.trajectory);
      model.global_map =
          global_map(perceived.scans, model.trajectory, {.resolution_m = resolution_m});
    } catch (const std::exception& error) {
      model.fault = error.what();
      model.trajectory.clear();
    }
    models.push_back(std::move(model));
  }
  return models;
}

Grid odometry_map(const Perceived& perceived, double resolution_m) {
  const std::vector<Scan>& scans = perceived.scans;
  Trajectory wheels;
  for (const Scan& scan : scans)
    wheels.push_back({scan.stamp_s, inverse(scans.front().odom_from_robot) * scan.odom_from_robot});
  return global_map(scans, wheels, {.resolution_m = resolution_m});
}

}  // namespace asterism
