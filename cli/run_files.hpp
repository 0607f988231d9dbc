#pragma once

#include <filesystem>
#include <optional>

#include "core/grid.hpp"
#include "core/ranked_map.hpp"
#include "core/trajectory.hpp"

namespace asterism {

/// One ranked model and all that follows from it.
struct DrawnModel {
  RankedMap ranked;
  Trajectory trajectory = {};
  Grid global_map = {};
};

/// Writes trajectory.tum, map.pgm, map.yaml, map.png, layout.g2o, map.graphml, map.dot and, if
/// there is a segment, routes.geojson.  @throws Error if it cannot
void write_model(const std::filesystem::path& folder, const DrawnModel& model);

/// Removes these files, as far as they are there.
void remove_model(const std::filesystem::path& folder);

}  // namespace asterism
