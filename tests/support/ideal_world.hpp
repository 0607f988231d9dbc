#pragma once

#include <string>
#include <vector>

#include "core/grid.hpp"

namespace asterism {

/// A corridor from a place outwards; it begins `back_m` behind the place's centre, so that
/// corridors of one place join without notches.
struct IdealCorridor {
  Point2 from = {};
  double heading_rad = 0;
  double width_m = 2;
  double length_m = 12;
  double back_m = 0;
};

/// A world without noise round one place: corridors, seen as far as they are long, and a hall.
struct IdealWorld {
  std::string name = {};
  std::string star = {};  ///< true local topology, as Star::parse reads it
  std::vector<IdealCorridor> corridors = {};
  double hall_m = 0;  ///< radius of a round hall at the origin; 0: none
};

/// One place of each kind, its centre at the origin: L, T, +, Y, dead end, round hall with four
/// necks, and last a straight corridor, which is no place.
std::vector<IdealWorld> ideal_worlds(double width_m);

IdealWorld turned(IdealWorld world, double angle_rad);
/// In the x-axis: heading h becomes -h.
IdealWorld mirrored(IdealWorld world);

/// Drawn as a robot would have seen it: free, walls 0.3 m thick, the rest unknown. The grid is
/// square, and its middle lies at the origin.
Grid drawn(const IdealWorld& world, int cells = 300, double resolution_m = 0.1);

/// A robot's position at the origin moves along with the world.
Point2 turned(Point2 point, double angle_rad);

}  // namespace asterism
