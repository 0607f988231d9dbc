#pragma once

#include <iosfwd>
#include <memory>
#include <string>

#include "core/pose2.hpp"

namespace asterism {

/// What the YAML of a map of map_server says of its picture.
struct MapYaml {
  std::string image;  ///< absolute, or relative to the YAML
  double resolution_m = 0;
  Pose2 map_from_grid = {};  ///< of the lower left corner
  bool is_negated = false;   ///< white is occupied, not black
  double occupied_threshold = 0.65;
  double free_threshold = 0.196;
};

/// Reads one, strictly: a key a line, each of
///
///   image: map.pgm
///   resolution: 0.05
///   origin: [-12.5, 3, 0]
///   negate: 0
///   occupied_thresh: 0.65
///   free_thresh: 0.196
///   mode: trinary
///
/// just once and no other, mode alone may be absent; comments and blank lines; names in quotes
/// or without. That is all of YAML that those who write such files use.
///
/// @param name  for messages
/// @throws InputError "file:line: found ...; expected ..."
MapYaml read_map_yaml(std::unique_ptr<std::istream> in, const std::string& name);

/// The content of such a YAML.  @throws std::invalid_argument if it could not be read back
std::string map_yaml(const MapYaml& yaml);

}  // namespace asterism
