#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "io/carmen_log.hpp"
#include "perception/place_detector.hpp"

namespace asterism {

// What `asterism perceive` and `asterism run` share.

/// The name without folder and without endings: drive of logs/drive.log.xz.
std::string stem_of(const std::string& file);

/// One visit as a line of text.
std::string visit_row(std::size_t number, const Visit& visit);

/// Shows a log to a detector, telling on stderr how far it is read if that takes long.
/// @param followed  called after the detector has seen a scan
/// @return the number of scans
std::size_t detect(LogReader& log, PlaceDetector& detector,
                   const std::function<void(const Scan&)>& followed,
                   const std::function<void(DetectedVisit)>& visited);

/// @throws InputError if there is no visit, std::invalid_argument if they make no valid trace
void require_visits(const Trace& trace, const std::string& log, std::size_t scans);

/// Writes the map of a visit's place.
/// @return  its file, from where the folder lies
std::string write_place_map(const std::filesystem::path& folder, std::size_t visit,
                            const Grid& place_map);

}  // namespace asterism
