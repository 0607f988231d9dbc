#pragma once

#include <string>
#include <vector>

#include "core/pose2.hpp"
#include "simulation/floor_plan.hpp"
#include "simulation/world.hpp"

namespace asterism {

/// A world with walls: what a laser can be carried through.
///
/// The gateways of a place's star are the openings that a robot there cannot see to the end: its
/// corridors, and halls that go on for farther than a local map reaches. What it sees to the end (a
/// blind stub, a closed lobby, a room behind an open door) is none.
struct Building {
  std::string name;
  World world;                         ///< its true places and their stars
  std::vector<double> place_radius_m;  ///< [place]: how far from its middle one is still at it
  std::vector<Wall> walls;
};

/// Where the arms of a place lead: their headings, in the order of its star. Where one has no
/// corridor, its opposite has, and it leads straight on.
/// @throws std::invalid_argument if neither has
std::vector<double> arm_headings_rad(const World& world, PlaceId place);

/// The building elsewhere: turned and shifted. Its stars stay.
Building moved(Building building, const Pose2& there_from_here);

/// The building as a mirror shows it: north is south. Arm i of n becomes arm n - 1 - i.
Building mirrored(const Building& building);

}  // namespace asterism
