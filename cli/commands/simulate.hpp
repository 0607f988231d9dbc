#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "simulation/walk.hpp"

namespace asterism {

struct SimulateCommand {
  std::string world = "grid";           ///< or "corridors"
  std::optional<std::string> building;  ///< "aces-like" or "office": scans of a drive, not a walk
  std::uint64_t seed = 0;
  std::optional<std::size_t> travels;
  std::optional<std::size_t> width;
  std::optional<std::size_t> height;
  double missing = 0.2;
  double stubs = 0.1;
  std::size_t corridors = 7;
  bool laps = false;
  bool plain = false;  ///< arms as the world lists them
  double turned_deg = 0;
  bool mirrored = false;
  std::size_t people = 2;
  std::string output = "-";
  std::optional<std::string> true_map;
  std::optional<std::string> true_trace;
  std::optional<std::string> true_trajectory;
  std::optional<std::string> svg;
};
inline constexpr std::size_t default_travels = 20;

/// Drives through a building and writes the log.
/// @pre    the command has a building
/// @return exit code
int simulate_drive(const SimulateCommand& command);

/// Writes the truth as a maps file of one map.  @throws Error if the file cannot be written
void write_true_map(const std::string& file, const Walk& walk);

}  // namespace asterism
