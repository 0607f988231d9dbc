#pragma once

#include <optional>
#include <vector>

#include "perception/frontier.hpp"
#include "perception/skeleton.hpp"

namespace asterism {

/// Whether a line ends in a cell of it: it has one neighbour, or two side by side.
bool is_end(const BitRows& lines, Cell cell);

/// The exit at each piece of frontier, if it has one: the end of a line that faces it through an
/// opening wide enough. Where a line forks before it, the end that faces more of it.
///
/// @return  of each piece, a position in `points`
/// @param lines   one cell wide
/// @param points  their cells
std::vector<std::optional<std::size_t>> exits_at(const Frontier& frontier, const BitRows& lines,
                                                 const std::vector<SkeletonPoint>& points,
                                                 const SkeletonOptions& options);

/// Where lines should end but do not: one cell of the thinned picture for each opening wide enough
/// for an exit that has none and that no point comes near. Thinning eats lines along a diagonal
/// from their ends on, at times whole.                                                    [ZS84]
///
/// @param exits  as exits_at() finds them
/// @param roomy  the picture that was thinned
BitRows missed_openings(const FreeSpace& space, const Frontier& frontier, const BitRows& roomy,
                        const std::vector<SkeletonPoint>& points,
                        const std::vector<std::optional<std::size_t>>& exits,
                        const SkeletonOptions& options);

}  // namespace asterism
