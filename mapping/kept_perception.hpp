#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "core/grid.hpp"
#include "io/log/carmen_log.hpp"
#include "mapping/perceived.hpp"
#include "perception/scan_detector.hpp"

namespace asterism {

/// A trace that takes the place of the one perceived, and the maps of its places.
struct ToldTrace {
  std::string file;
  std::string map_folder;  ///< log.lpm of a run on the same log
};

/// Writes the map of a visit's place.
/// @return  its file, from where the folder lies
std::string write_place_map(const std::filesystem::path& folder, std::size_t visit,
                            const Grid& place_map);

/// Writes what was perceived into a folder of results: log.trace.json, and in log.lpm the maps of
/// its places and perception.json.  @throws Error if it cannot
void keep_perceived(const std::filesystem::path& results, const Perceived& perceived);

/// What was perceived of a log, taken up from the results of an earlier run.
/// @return  nothing unless all of it is there, of just this log, by this version with the same
///          least width of gateways
/// @throws InputError if the trace there is a person's: told, or changed since
std::optional<Perceived> perceived_before(const std::filesystem::path& results,
                                          const std::string& log, const LogOptions& laser,
                                          const ScanDetectorOptions& detector,
                                          const ReadWatch& watch);

/// A log with a trace that somebody tells. Its visits name scans of the log, in order, and beside
/// the first their displacements; what they name as their place maps lies in the map folder.
/// @throws InputError if a file cannot be read, or they do not fit together
Perceived perceived_as_told(const ToldTrace& told, const std::string& log, const LogOptions& laser,
                            const ReadWatch& watch);

}  // namespace asterism
