#pragma once

#include <string>

#include "core/grid.hpp"
#include "io/grid/map_yaml.hpp"
#include "io/grid/pgm_image.hpp"

namespace asterism {

/// Occupancy maps as map_server of ROS and nav2 read and write them: a YAML (io/map_yaml.hpp) that
/// names a grey picture, top row first. A grey g tells how occupied a cell is, p = (255 - g) / 255,
/// or g / 255 if negated: above occupied_thresh it is occupied, below free_thresh free, else
/// unknown ("trinary"), which is read as the log-odds of grey 0, their opposite and 0.
///
/// Written are 0 for occupied, 254 for free and 205 for unknown cells, and the thresholds 0.65 and
/// 0.196, by which the log-odds were judged. nav2 writes a free_thresh of 0.25, by which its own
/// 205, p = 0.1961, is read as free; with 0.196 every reader keeps it unknown.

/// Reads an occupancy map from its two files.
/// @param file  the YAML
/// @throws InputError "file: found ...; expected ...", as read_map_yaml and read_pgm
Grid read_occupancy_map_file(const std::string& file);

/// The grid that a YAML and its picture tell of.
Grid occupancy_map(const MapYaml& yaml, const GreyImage& image);

/// Writes NAME.yaml and NAME.pgm beside it, the PGM first: each whole or not at all.
/// @param file  the YAML; ends in .yaml
/// @throws std::invalid_argument if the map could not be read back or `file` ends otherwise, Error
///         if a file cannot be written
void write_occupancy_map_file(const std::string& file, const Grid& grid);

}  // namespace asterism
