#pragma once

#include <span>

#include "perception/skeleton.hpp"

namespace asterism {

/// Keeps the part of a skeleton that matters: the union of
///  - the shortest paths between its exits;
///  - loops too long to lead round a piece of furniture;
///  - hallways seen to their end, and where the robot drove: a dead end is a place of its own.
/// With one exit and none of these, the branch to the junction nearest the dead end.
///                                                               [theory §11, 4] [BMK10, §5.1.1]
///
/// @param frame  of the skeleton's cells
/// @param driven  where the robot drove, in the frame of `frame`
void keep_critical(Skeleton& skeleton, const Grid& frame, const SkeletonOptions& options,
                   std::span<const Point2> driven);

}  // namespace asterism
