#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/grid.hpp"

namespace asterism {

/// What a picture of one place shows, as in [BMK10, Figs 8-11]; all in one frame.
struct PlacePicture {
  struct Disc {
    Point2 middle = {};
    double radius_m = 0;
  };
  struct Arm {
    std::string label = {};  ///< "a+1": name and α
    Point2 from = {};        ///< middle of its gateway, or of the one it goes on from if α = 0
    double outward_rad = 0;
    std::optional<double> width_m = {};  ///< of its gateway; none: α = 0
  };
  std::string title = {};
  Grid map = {};
  std::vector<Point2> skeleton = {};  ///< all of it
  std::vector<Point2> pruned = {};
  std::vector<Disc> core = {};
  std::vector<Arm> arms = {};
  std::vector<Point2> way = {};  ///< of the robot
};

/// A picture of a place: grey the map, blue the full skeleton, red the pruned one, green the core,
/// orange the robot's way; an arrow a gateway, its tail on the line across it.
std::string place_svg(const PlacePicture& picture);

/// Small pictures of all visits, in rows.
std::string strip_svg(const std::vector<PlacePicture>& pictures, const std::string& title);

/// A visit on the robot's way.
struct NumberedPoint {
  std::size_t number = 0;
  Point2 at = {};
};

/// The robot's way in the frame of its start as perception has it, visits numbered along it.
std::string way_svg(const std::vector<Point2>& way, const std::vector<NumberedPoint>& visits,
                    const std::string& title);

}  // namespace asterism
