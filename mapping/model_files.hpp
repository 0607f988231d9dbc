#pragma once

#include <array>
#include <filesystem>

#include "mapping/drawn_model.hpp"

namespace asterism {

/// What the files of a model are called.
inline constexpr std::array model_file_names{"trajectory.tum", "map.pgm",        "map.yaml",
                                             "map.png",        "layout.g2o",     "map.graphml",
                                             "map.dot",        "routes.geojson", "routes.osm"};

/// Writes them: those of the trajectory and the grid if there is one, and those of the routes if
/// there is a segment, too.  @throws Error if it cannot
void write_model(const std::filesystem::path& folder, const DrawnModel& model);

}  // namespace asterism
