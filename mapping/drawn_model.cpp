#include "mapping/drawn_model.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <system_error>
#include <thread>
#include <utility>

#include "metric/driven_ways.hpp"
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

void draw(const Perceived& perceived, double resolution_m, bool is_refined, DrawnModel& model) try {
  const std::vector<Scan>& scans = perceived.scans;
  model.trajectory = fit_trajectory(perceived.poses, anchors(perceived.trace, model.ranked));
  if (is_refined) model.trajectory = Refinement(scans, perceived.poses)(model.trajectory);
  model.global_map = global_map(scans, model.trajectory, {.resolution_m = resolution_m});
  model.ways = driven_ways(perceived.trace, model.ranked.map, model.trajectory, *model.global_map);
} catch (const std::exception& error) {
  model.fault = error.what();
  model.trajectory.clear();
  model.global_map.reset();
}

}  // namespace

std::vector<DrawnModel> draw_models(const Perceived& perceived, std::vector<RankedMap> ranked,
                                    double resolution_m) {
  std::vector<DrawnModel> models;
  for (RankedMap& map : ranked) models.push_back({std::move(map)});
  // Each is drawn apart from the others; so few at a time that their grids fit into memory.
  constexpr std::size_t most_threads = 4;
  std::atomic<std::size_t> next = 0;
  const auto draw_on = [&] {
    for (std::size_t i = next++; i < models.size(); i = next++)
      draw(perceived, resolution_m, i == 0, models[i]);
  };
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::jthread> threads;
  try {
    while (threads.size() + 1 < std::min({models.size(), cores, most_threads}))
      threads.emplace_back(draw_on);
  } catch (const std::system_error&) {  // there may be no more: this one draws the rest
  }
  draw_on();
  threads.clear();  // which waits for them
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
