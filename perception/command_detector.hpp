#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "perception/place_detector.hpp"

namespace asterism {

/// A program that finds places.                                             [docs/detectors.md]
struct DetectorProgram {
  std::string command;      ///< for the shell
  double patience_s = 300;  ///< the longest it may neither read nor write nor end
};

/// A scan as a line, without its end.
using ScanWriter = std::function<std::string(const Scan&)>;
/// The visit of a line; `where` names command and line.  @throws Error "where: found ...; ..."
using VisitReader = std::function<Visit(std::string_view line, const std::string& where)>;

/// No line of a visit is longer.
inline constexpr std::size_t max_visit_line_bytes = std::size_t{1} << 20;

/// The detector that this program is: each scan goes to its standard input as a line, each line of
/// its standard output is a visit. It answers when it likes, so the visits are the same in every
/// run, but not the scans at which they are handed over. What it writes to its error stream appears
/// on ours. It is held to the laws of perception/detector_laws.hpp, and killed when the detector is
/// let go.
///
/// observe and finish throw PluginError "command: found ...; expected ..." if it ends before the
/// scans do, or with a status other than 0, or not in time; or "command:line 7: ..." if a line is
/// no visit, longer than max_visit_line_bytes or cut short. Neither is to be called by two threads
/// at a time.
///
/// With io/detector_lines.hpp: command_detector({"python3 places.py"}, scan_line, read_visit_line)
/// @throws PluginError if the program cannot be started
std::unique_ptr<PlaceDetector> command_detector(const DetectorProgram& command,
                                                ScanWriter scan_line, VisitReader read_visit_line);

}  // namespace asterism
