#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/driven_way.hpp"
#include "core/grid.hpp"
#include "core/ranked_map.hpp"
#include "core/trajectory.hpp"
#include "mapping/perceived.hpp"

namespace asterism {

/// One ranked map and all that follows from it.
struct DrawnModel {
  RankedMap ranked;
  Trajectory trajectory = {};
  std::optional<Grid> global_map = {};  ///< in the layout's frame; absent where it has a fault
  DrivenWays ways = {};                 ///< on it; none where it has a fault
  std::string fault = {};               ///< why it could not be drawn
};

/// Fits a trajectory to the layout of each ranked map and draws all scans from there, and the
/// lines driven. That of the first is refined first, on the walls that the scans saw. What one
/// cannot be drawn for costs its own drawing alone. [BMK10, §7.3] [theory §12]
/// @param ranked        best first, of the perceived trace or a part of it
/// @param resolution_m  side of a cell of the global map, where that makes not too many of them
std::vector<DrawnModel> draw_models(const Perceived& perceived, std::vector<RankedMap> ranked,
                                    double resolution_m);

/// The scans drawn where the wheels say.
Grid odometry_map(const Perceived& perceived, double resolution_m);

}  // namespace asterism
