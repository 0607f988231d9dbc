#pragma once

#include <vector>

#include "core/scan.hpp"

namespace asterism {

/// A drive through two metres wide corridors, with a laser of 180° and wheels that do not slip. At
/// each place the robot halts and turns once round before it goes on:
///
///             |
///      start  |                     visit 0: C, from the west to the east
///        o----C-----------T----     visit 1: T, from the west to the west
///             |           |         visit 2: C, from the east to the north
///             |           |
///
std::vector<Scan> corridor_drive();

}  // namespace asterism
