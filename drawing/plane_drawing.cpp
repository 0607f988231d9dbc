#include "drawing/plane_drawing.hpp"

#include <algorithm>
#include <utility>

#include "drawing/crossings.hpp"
#include "drawing/fan.hpp"
#include "drawing/grid_layout.hpp"
#include "drawing/jogs.hpp"
#include "drawing/orthogonal_shape.hpp"
#include "drawing/plane_graph.hpp"

namespace asterism {
namespace {

using Edge = PlaneGraph::Edge;
using Point = MapDrawing::Point;

constexpr double fan_radius = 0.2;  ///< below half the least side of a cage, two grid steps
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
  explicit Drafter(const TopologicalMap& map)
      : map_(map),
        graph_(with_orthogonal_shape(plane_graph(map))),
        grid_(grid_layout(graph_, first_arm())) {
    if (PlaneGraph jogged = with_jogs(graph_, grid_); jogged.dart_count() > graph_.dart_count()) {
      graph_ = std::move(jogged);
      grid_ = grid_layout(graph_, first_arm());
    }
    darts_ = arm_darts(map, graph_);
  }

  MapDrawing drawing() const {
    MapDrawing result;
    for (const auto& darts : darts_) {
      result.places.push_back(centre(darts));
      result.arms.push_back(arms(darts, result.places.back()));
    }
    for (const auto& [one, other] : map_.segments)
      result.segments.push_back(line(one, other, result));
    result.without_crossings = is_plane(map_, result);
    return result;
  }

 private:
  std::size_t first_arm() const { return arm_darts(map_, graph_).at(0).at(0); }

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

  /// One grid step along each arm; in a cage, the knee of its line.
  std::vector<Point> arms(const std::vector<std::size_t>& darts, Point centre) const {
    std::vector<Point> points;
    if (is_cage(darts)) {
      std::vector<Point> rim;
      for (const std::size_t d : darts) rim.push_back(at(graph_[d].origin));
      for (const auto& line : fan(centre, rim, fan_radius)) points.push_back(line[1]);
      return points;
    }
    for (const std::size_t d : darts) {
      const Point from = at(graph_[d].origin);
      const Point to = at(graph_.target(d));
      points.push_back({centre.x + std::clamp(to.x - from.x, -grid_step, grid_step),
                        centre.y + std::clamp(to.y - from.y, -grid_step, grid_step)});
    }
    return points;
  }

  MapDrawing::Polyline line(PlaceArm from, PlaceArm to, const MapDrawing& drawing) const {
    MapDrawing::Polyline points = way_out(from, drawing);
    std::size_t d = darts_[from.place.index()][from.arm];
    for (; graph_[d ^ 1].arm != to; d = graph_.onward(d))
      if (graph_.degree(d) == 2) points.push_back(at(graph_.target(d)));
    const MapDrawing::Polyline way_in = way_out(to, drawing);
    points.insert(points.end(), way_in.rbegin(), way_in.rend());
    return points;
  }

  /// From the place to the edge of its arm.
  MapDrawing::Polyline way_out(PlaceArm arm, const MapDrawing& drawing) const {
    const std::size_t place = arm.place.index();
    MapDrawing::Polyline points{drawing.places[place]};
    if (is_cage(darts_[place])) {
      points.push_back(drawing.arms[place][arm.arm]);
      points.push_back(at(graph_[darts_[place][arm.arm]].origin));
    }
    return points;
  }

  const TopologicalMap& map_;
  PlaneGraph graph_;
  std::vector<GridPoint> grid_;
  ArmDarts darts_;
};

}  // namespace

MapDrawing draw(const TopologicalMap& map) { return Drafter(map).drawing(); }

}  // namespace asterism
