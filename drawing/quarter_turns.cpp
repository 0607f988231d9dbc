#include "drawing/quarter_turns.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace asterism {
namespace {

using Point = MapDrawing::Point;

Point quarter_turned(Point point) { return {-point.y, point.x}; }

Point middle_of(const std::vector<Point>& points) {
  Point sum;
  for (const Point& point : points) sum = {sum.x + point.x, sum.y + point.y};
  const auto count = static_cast<double>(points.size());
  return {sum.x / count, sum.y / count};
}

// How alike two rows of points lie: by the drawing as it is, and turned by one, two, three
// quarters.
std::array<double, 4> likeness(const std::vector<Point>& drawn, const std::vector<Point>& as) {
  const Point drawn_middle = middle_of(drawn);
  const Point middle = middle_of(as);
  double along = 0;
  double across = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const Point a{drawn[i].x - drawn_middle.x, drawn[i].y - drawn_middle.y};
    const Point b{as[i].x - middle.x, as[i].y - middle.y};
    along += a.x * b.x + a.y * b.y;
    across += a.x * b.y - a.y * b.x;
  }
  return {along, across, -along, -across};
}

}  // namespace

MapDrawing turned(MapDrawing drawing, const std::vector<Point>& as) {
  if (as.size() != drawing.places.size())
    throw std::invalid_argument("drawing: found " + std::to_string(as.size()) +
                                " points to turn it by; expected " +
                                std::to_string(drawing.places.size()));
  if (as.empty()) return drawing;
  const std::array<double, 4> by_turns = likeness(drawing.places, as);
  std::size_t best = 0;
  for (std::size_t turns = 1; turns < by_turns.size(); ++turns)
    if (by_turns[turns] > by_turns[best]) best = turns;
  for (std::size_t turn = 0; turn < best; ++turn) {
    for (Point& place : drawing.places) place = quarter_turned(place);
    for (MapDrawing::Polyline& segment : drawing.segments)
      for (Point& point : segment) point = quarter_turned(point);
    for (std::vector<Point>& arms : drawing.arms)
      for (Point& arm : arms) arm = quarter_turned(arm);
  }
  return drawing;
}

}  // namespace asterism
