#pragma once

#include <string>

#include "io/log/carmen_log.hpp"
#include "perception/scan_detector.hpp"

namespace CLI {
class App;
}

namespace asterism {

/// The log, and what is known of the laser.
void add_log(CLI::App& command, std::string& log, LogOptions& laser);
/// What is too narrow to lead anywhere.
void add_gateway_width(CLI::App& command, ScanDetectorOptions& detector);

}  // namespace asterism
