#pragma once

#include <cstddef>
#include <vector>

#include "core/pose2.hpp"

namespace asterism {

/// A convex polygon: its corners, counter-clockwise.
using Polygon = std::vector<Point2>;

/// A straight piece of wall. Glass gives a laser back a few beams only.
struct Wall {
  Point2 from;
  Point2 to;
  bool is_glass = false;
};

/// The rectangle of this width whose middle line runs between two points that differ.
Polygon rectangle(Point2 from, Point2 to, double width_m);
/// A regular polygon on a circle.
Polygon disc(Point2 centre, double radius_m, std::size_t corners = 48);

/// Whether two polygons have inner points in common.
bool overlap(const Polygon& a, const Polygon& b);

/// A floor as an architect draws it: rooms and corridors, which run into one another where they
/// overlap, and what stands in them.
struct FloorPlan {
  std::vector<Polygon> rooms;
  std::vector<Polygon> furniture;
  std::vector<Wall> panes;  ///< of glass
};

/// Everything a beam can hit: the outline of all rooms together, the sides of the furniture, the
/// panes. Where sides of two rooms lie on one another with both rooms on one side, both stay.
std::vector<Wall> walls_of(const FloorPlan& plan);

}  // namespace asterism
