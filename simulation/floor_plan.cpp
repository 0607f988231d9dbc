#include "simulation/floor_plan.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

namespace asterism {
namespace {

/// Sides nearer to one another than this lie on one another.
constexpr double coincident_m = 1e-9;

using Interval = std::pair<double, double>;

const Point2& after(const Polygon& polygon, std::size_t corner) {
  return polygon[(corner + 1) % polygon.size()];
}

/// Which part of the line from + t (to - from), 0 ≤ t ≤ 1, lies inside a polygon; empty: low ≥
/// high.
Interval part_inside(Point2 from, Point2 to, const Polygon& polygon) {
  Interval inside{0, 1};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 side = after(polygon, i) - polygon[i];
    const double length_m = norm(side);
    const double at_from_m = cross(side, from - polygon[i]) / length_m - coincident_m;
    const double at_to_m = cross(side, to - polygon[i]) / length_m - coincident_m;
    if (at_from_m <= 0 && at_to_m <= 0) return {1, 0};
    const double crossing = at_from_m / (at_from_m - at_to_m);
    if (at_from_m <= 0) inside.first = std::max(inside.first, crossing);
    if (at_to_m <= 0) inside.second = std::min(inside.second, crossing);
  }
  return inside;
}

/// What is left of one side of room `own` outside all the other rooms.
void add_outline(Point2 from, Point2 to, const std::vector<Polygon>& rooms, std::size_t own,
                 std::vector<Wall>& walls) {
  std::vector<Interval> hidden;
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    if (i == own) continue;
    const Interval inside = part_inside(from, to, rooms[i]);
    if (inside.first < inside.second) hidden.push_back(inside);
  }
  std::sort(hidden.begin(), hidden.end());
  hidden.emplace_back(1, 1);
  double shown_to = 0;
  for (const auto& [first, last] : hidden) {
    if ((first - shown_to) * norm(to - from) > coincident_m)
      walls.push_back({from + shown_to * (to - from), from + first * (to - from)});
    shown_to = std::max(shown_to, last);
  }
}

/// Whether a side of `a` has all of `b` on its outer side.
bool is_parted_by_a_side(const Polygon& a, const Polygon& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto is_outside = [&](Point2 corner) {
      return cross(after(a, i) - a[i], corner - a[i]) <= 0;
    };
    if (std::all_of(b.begin(), b.end(), is_outside)) return true;
  }
  return false;
}

}  // namespace

Polygon rectangle(Point2 from, Point2 to, double width_m) {
  const Point2 left = (width_m / 2) * left_of(unit_towards(from, to));
  return {from - left, to - left, to + left, from + left};
}

Polygon disc(Point2 centre, double radius_m, std::size_t corners) {
  Polygon result;
  for (std::size_t i = 0; i < corners; ++i) {
    const double turned = static_cast<double>(i) / static_cast<double>(corners);
    result.push_back(centre + radius_m * unit_vector(2 * std::numbers::pi * turned));
  }
  return result;
}

bool overlap(const Polygon& a, const Polygon& b) {
  return !is_parted_by_a_side(a, b) && !is_parted_by_a_side(b, a);
}

std::vector<Wall> walls_of(const FloorPlan& plan) {
  std::vector<Wall> walls;
  for (std::size_t room = 0; room < plan.rooms.size(); ++room) {
    const Polygon& outline = plan.rooms[room];
    for (std::size_t i = 0; i < outline.size(); ++i)
      add_outline(outline[i], after(outline, i), plan.rooms, room, walls);
  }
  for (const Polygon& piece : plan.furniture)
    for (std::size_t i = 0; i < piece.size(); ++i) walls.push_back({piece[i], after(piece, i)});
  for (Wall pane : plan.panes) {
    pane.is_glass = true;
    walls.push_back(pane);
  }
  return walls;
}

}  // namespace asterism
