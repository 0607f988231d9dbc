#pragma once

#include <span>
#include <vector>

#include "core/ssh_map.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"

namespace asterism {

/// A trace of visits as an experience of the basic SSH.            [BMK10, Fig. 5] [theory §4]
///
/// The robot arrives facing opposite the arm entered by (at a first visit that does not say, it
/// faces the arm it leaves by), sees the star read from the arm it faces, turns `turn:k`, k arms
/// clockwise, or `turn_around` to the opposite arm, or not at all, and travels. The arm that the
/// last visit was left by is not used, as no map depends on it.
Experience basic_ssh(const Trace& trace);

/// The dstates of those views in a map of the trace: two are one if the map has the robot at one
/// place, facing one arm.
/// @param hypothesis  where each visit was; of all visits, places numbered by first visit
std::vector<DStateId> basic_ssh_dstates(const Trace& trace, std::span<const Arrival> hypothesis);

}  // namespace asterism
