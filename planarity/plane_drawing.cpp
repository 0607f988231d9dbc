#include "planarity/plane_drawing.hpp"

#include <algorithm>
#include <cassert>

#include "planarity/crossings.hpp"
#include "planarity/grid_layout.hpp"
#include "planarity/orthogonal_shape.hpp"
#include "planarity/plane_graph.hpp"

namespace asterism {
namespace {

using Edge = PlaneGraph::Edge;
using Point = MapDrawing::Point;

constexpr double grid_step = 0.25;  ///< a power of two, so that all points are exact

using ArmDarts = std::vector<std::vector<std::size_t>>;  ///< [place][arm]

ArmDarts arm_darts(const TopologicalMap& map, const PlaneGraph& graph) {
  ArmDarts darts;
  for (const auto& place : map.places) darts.emplace_back(place.star.size());
  for (std::size_t d = 0; d < graph.dart_count(); ++d)
    if (const auto& arm = graph[d].arm) darts[arm->place.index()][arm->arm] = d;
  return darts;
}

class Drafter {
 public:
  Drafter(const TopologicalMap& map)
      : map_(map),
        graph_(with_orthogonal_shape(plane_graph(map))),
        darts_(arm_darts(map, graph_)),
        grid_(grid_layout(graph_, darts_.at(0).at(0))) {}

  MapDrawing drawing() const {
    MapDrawing result;
    for (const auto& darts : darts_) {
      result.places.push_back(centre(darts));
      result.arms.push_back(arms(darts, result.places.back()));
    }
    for (const auto& [one, other] : map_.segments)
      result.segments.push_back(
          line(one, result.places[one.place.index()], result.places[other.place.index()]));
    result.without_crossings = is_plane(map_, result);
    return result;
  }

 private:
  Point at(std::size_t vertex) const {
    return {grid_step * static_cast<double>(grid_[vertex].x),
            grid_step * static_cast<double>(grid_[vertex].y)};
  }

  static bool is_cage(const std::vector<std::size_t>& darts) { return darts.size() > 4; }

  /// The middle of the place's vertices.
  Point centre(const std::vector<std::size_t>& darts) const {
    Point low = at(graph_[darts.front()].origin);
    Point high = low;
    for (const std::size_t d : darts) {
      const Point corner = at(graph_[d].origin);
      low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
      high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
    }
    return {(low.x + high.x) / 2, (low.y + high.y) / 2};
  }

  /// One grid step along each arm; in a cage, half-way to its corner.
  std::vector<Point> arms(const std::vector<std::size_t>& darts, Point centre) const {
    std::vector<Point> points;
    for (const std::size_t d : darts) {
      const Point from = at(graph_[d].origin);
      const Point to = at(graph_.target(d));
      if (is_cage(darts))
        points.push_back({(centre.x + from.x) / 2, (centre.y + from.y) / 2});
      else
        points.push_back({centre.x + std::clamp(to.x - from.x, -grid_step, grid_step),
                          centre.y + std::clamp(to.y - from.y, -grid_step, grid_step)});
    }
    return points;
  }

  MapDrawing::Polyline line(PlaceArm arm, Point start, Point end) const {
    MapDrawing::Polyline points{start};
    const auto& from = darts_[arm.place.index()];
    if (is_cage(from)) points.push_back(at(graph_[from[arm.arm]].origin));
    std::size_t d = from[arm.arm];
    while (!graph_[d ^ 1].arm) {
      if (graph_.degree(d) == 2) points.push_back(at(graph_.target(d)));
      d = graph_.onward(d);
    }
    const std::size_t reached = graph_[d ^ 1].arm->place.index();
    if (is_cage(darts_[reached])) points.push_back(at(graph_.target(d)));
    points.push_back(end);
    return points;
  }

  const TopologicalMap& map_;
  PlaneGraph graph_;
  ArmDarts darts_;
  std::vector<GridPoint> grid_;
};

}  // namespace

MapDrawing draw(const TopologicalMap& map) { return Drafter(map).drawing(); }

}  // namespace asterism
