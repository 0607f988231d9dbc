#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/grid.hpp"
#include "core/scan.hpp"
#include "core/trace.hpp"
#include "io/log/carmen_log.hpp"
#include "metric/trajectory.hpp"
#include "perception/place_detector.hpp"
#include "perception/scan_detector.hpp"

namespace asterism {

/// What perception made of a log.
struct Perceived {
  Trace trace = {};
  std::vector<std::optional<Grid>> place_maps = {};  ///< of each visit
  std::vector<Scan> scans = {};
  std::vector<LocalPose> poses = {};      ///< of each scan
  std::vector<std::string> remarks = {};  ///< what is odd about the log, each in a sentence
  std::string by = {};                    ///< version and options: the same perceive the same
  bool is_kept = false;                   ///< taken up from an earlier run
};

/// What perceives with these options, all but the least width of gateways as they are shipped.
std::string name_of(const ScanDetectorOptions& options);

/// Told, after each scan, how far the log is read and what is perceived so far.
using ReadWatch = std::function<void(const LogReader&, const Perceived&)>;

/// Shows a log to the detector that ships. Its place maps are as their files will tell.
/// @throws InputError if the log cannot be read, or no place is found in it
Perceived perceive(
    const std::string& file, const LogOptions& laser = {}, const ScanDetectorOptions& options = {},
    const ReadWatch& watch = [](const LogReader&, const Perceived&) {});

/// Shows a log to any detector.
/// @param seen     called after the detector has seen a scan
/// @param visited  called for each visit that has ended
/// @return the number of scans
std::size_t detect(LogReader& log, PlaceDetector& detector,
                   const std::function<void(const Scan&)>& seen,
                   const std::function<void(DetectedVisit)>& visited);

/// @throws InputError if there is no visit, std::invalid_argument if they make no valid trace
void require_visits(const Trace& trace, const std::string& log, std::size_t scans);

/// A log's or a trace's name, without folder and without endings: drive of logs/drive.log.xz.
std::string stem_of(const std::string& file);

}  // namespace asterism
