#pragma once

#include <limits>
#include <span>
#include <string>

#include "core/driven_way.hpp"
#include "core/pose2.hpp"
#include "core/topological_map.hpp"

namespace asterism {

/// What a number of a file may be: between two whole numbers, above 0, or any that is finite.
struct Bounds {
  double low = -std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::max();

  bool contain(double value) const { return value >= low && value <= high; }
};
inline constexpr Bounds above_0{std::numeric_limits<double>::min()};
inline constexpr Bounds position_bounds_m{-1e7, 1e7};   ///< so that cells stay countable
inline constexpr Bounds heading_bounds_rad{-1e6, 1e6};  ///< in any number of turns

/// Throws std::invalid_argument "what: found ...; expected ..." unless the pose is in the bounds of
/// those that are read.
void require_writable(const Pose2& pose, const std::string& what);

/// Throws std::invalid_argument unless there is a pose in the bounds for each place of a map.
void require_poses(const TopologicalMap& map, std::span<const Pose2> layout_from_place);

/// Throws std::invalid_argument unless there is a way in the bounds for each segment of a map.
void require_ways(const TopologicalMap& map, std::span<const DrivenWay> ways);

}  // namespace asterism
