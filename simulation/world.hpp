#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/pose2.hpp"
#include "core/star.hpp"
#include "core/topological_map.hpp"

namespace asterism {

/// A straight corridor through some of a world's points.
struct Corridor {
  std::string label;                ///< names its local-paths
  Point2 direction;                 ///< of +; any length but 0
  std::vector<std::size_t> points;  ///< in order along +
  bool stub_at_start = false;       ///< goes on beyond its first point, to nowhere
  bool stub_at_end = false;         ///< goes on beyond its last point, to nowhere
};

/// Places joined by segments, connected, in the plane: x to the east, y to the north. A gateway
/// without a segment belongs to a blind stub: one could travel there, but it leads to nowhere.
struct World {
  /// A place: where it is, and its star.
  struct Place {
    Point2 position;
    Star star;
  };
  std::vector<Place> places;
  std::map<PlaceArm, PlaceArm> segments;  ///< gateway to gateway, both ways
};

/// The world of these corridors: its largest connected part, the first of equals, without places if
/// there is none. A place is a point where corridors cross, bend or end; a point passed by one
/// corridor alone is none. Where a corridor ends at a place, its other direction stands in the star
/// with α = 0, as it would have gone on.                                       [theory §1, §11]
///
/// @pre  no two corridors share more than one point
World make_world(const std::vector<Point2>& points, const std::vector<Corridor>& corridors);

/// Whether no path of the world meets a place twice: what straight corridors guarantee, and the
/// axioms ask for.                                                                [theory §5 (8)]
bool paths_are_straight(const World& world);

}  // namespace asterism
