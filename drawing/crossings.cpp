#include "drawing/crossings.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace asterism {
namespace {

using Point = MapDrawing::Point;

bool same(Point a, Point b) { return a.x == b.x && a.y == b.y; }

/// Twice the area of a, b, c: positive if they turn left.
double area(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Is p, known to be on the line through a and b, between them?
bool is_between(Point a, Point p, Point b) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

bool is_on(Point p, Point a, Point b) { return area(a, b, p) == 0 && is_between(a, p, b); }

/// A straight piece of an arm or a segment.
struct Piece {
  Point from;
  Point to;
  std::size_t line = 0;
  std::size_t number = 0;  ///< within the line
  std::optional<std::size_t> from_place = {};
  std::optional<std::size_t> to_place = {};
};

bool meet(const Piece& a, const Piece& b) {
  if (is_on(a.from, b.from, b.to) || is_on(a.to, b.from, b.to)) return true;
  if (is_on(b.from, a.from, a.to) || is_on(b.to, a.from, a.to)) return true;
  return (area(a.from, a.to, b.from) > 0) != (area(a.from, a.to, b.to) > 0) &&
         (area(b.from, b.to, a.from) > 0) != (area(b.from, b.to, a.to) > 0);
}

/// Do they meet elsewhere than in one common end?
bool meet_beyond_an_end(const Piece& a, const Piece& b) {
  for (const auto& [shared, a_end] : {std::pair(a.from, a.to), std::pair(a.to, a.from)})
    for (const auto& [b_shared, b_end] : {std::pair(b.from, b.to), std::pair(b.to, b.from)})
      if (same(shared, b_shared)) return is_on(a_end, b.from, b.to) || is_on(b_end, a.from, a.to);
  return meet(a, b);
}

/// Do they meet, other than at the place both start from or as neighbours in one line?
bool conflict(const Piece& a, const Piece& b) {
  const bool are_neighbours =
      a.line == b.line && (a.number == b.number + 1 || b.number == a.number + 1);
  const bool share_a_place =
      (a.from_place && (a.from_place == b.from_place || a.from_place == b.to_place)) ||
      (a.to_place && (a.to_place == b.from_place || a.to_place == b.to_place));
  return are_neighbours || share_a_place ? meet_beyond_an_end(a, b) : meet(a, b);
}

bool conflict(const std::vector<Piece>& pieces) {
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (conflict(pieces[i], pieces[j])) return true;
  return false;
}

/// Half the plane right of the upward vertical through 0 first: clockwise from north.
bool is_before(Point a, Point b) {
  const auto half = [](Point p) { return p.x > 0 || (p.x == 0 && p.y > 0) ? 0 : 1; };
  if (half(a) != half(b)) return half(a) < half(b);
  return a.x * b.y - a.y * b.x < 0;
}

bool is_clockwise(Point centre, const std::vector<Point>& arms) {
  std::size_t descents = 0;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    const Point next = arms[(i + 1) % arms.size()];
    const Point a{arms[i].x - centre.x, arms[i].y - centre.y};
    const Point b{next.x - centre.x, next.y - centre.y};
    if (!is_before(a, b)) ++descents;
  }
  return descents == 1;
}

/// Does the line leave its first point towards `arm`?
bool leaves_along(const MapDrawing::Polyline& line, Point arm) {
  const Point a{line[1].x - line[0].x, line[1].y - line[0].y};
  const Point b{arm.x - line[0].x, arm.y - line[0].y};
  return area(line[0], line[1], arm) == 0 && a.x * b.x + a.y * b.y > 0;
}

}  // namespace

bool is_plane(const TopologicalMap& map, const MapDrawing& drawing) {
  std::vector<Piece> pieces;
  std::set<PlaceArm> has_segment;
  for (std::size_t s = 0; s < map.segments.size(); ++s) {
    const auto& [one, other] = map.segments[s];
    const auto& line = drawing.segments[s];
    const MapDrawing::Polyline back(line.rbegin(), line.rend());
    if (!leaves_along(line, drawing.arms[one.place.index()][one.arm])) return false;
    if (!leaves_along(back, drawing.arms[other.place.index()][other.arm])) return false;
    for (std::size_t i = 1; i < line.size(); ++i) pieces.push_back({line[i - 1], line[i], s, i});
    pieces[pieces.size() + 1 - line.size()].from_place = one.place.index();
    pieces.back().to_place = other.place.index();
    has_segment.insert({one, other});
  }
  for (std::size_t p = 0; p < map.places.size(); ++p) {
    if (!is_clockwise(drawing.places[p], drawing.arms[p])) return false;
    for (std::size_t arm = 0; arm < drawing.arms[p].size(); ++arm)
      if (!has_segment.contains({PlaceId(p), arm}))
        pieces.push_back({drawing.places[p], drawing.arms[p][arm], map.segments.size(), 0, p, {}});
  }
  return !conflict(pieces);
}

bool meet_only_at_start(const std::vector<MapDrawing::Polyline>& lines) {
  std::vector<Piece> pieces;
  for (std::size_t line = 0; line < lines.size(); ++line)
    for (std::size_t i = 1; i < lines[line].size(); ++i) {
      pieces.push_back({lines[line][i - 1], lines[line][i], line, i});
      if (i == 1) pieces.back().from_place = 0;
    }
  return !conflict(pieces);
}

}  // namespace asterism
