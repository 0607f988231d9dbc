#pragma once

#include <vector>

namespace asterism {

/// Where a map's parts lie in a drawing. Units are arbitrary, about 1 between neighbouring places;
/// x to the right, y up.
struct MapDrawing {
  /// A point of the drawing.
  struct Point {
    double x = 0;
    double y = 0;
  };
  /// The ends of straight pieces, one after another.
  using Polyline = std::vector<Point>;

  std::vector<Point> places;       ///< one a place of the map
  std::vector<Polyline> segments;  ///< one a segment, from its smaller gateway to the larger
  std::vector<std::vector<Point>>
      arms;                        ///< [place][arm]: a point beside the place, in the direction
                                   ///< in which the arm leaves it; clockwise as in the star
  bool without_crossings = false;  ///< no two segments, places or arms meet
};

}  // namespace asterism
