#pragma once

#include <string>
#include <string_view>

#include "core/scan.hpp"
#include "core/trace.hpp"

namespace asterism {

/// A scan as a detector's command reads it: one line of JSON, without the line's end.
///                                                                         [docs/detectors.md]
/// @throws std::invalid_argument if a number of it is not finite
std::string scan_line(const Scan& scan);

/// A visit as a detector's command writes it: one line of JSON, the visit object of a trace file.
/// What the visits before and after it demand is not checked here.
///
/// @param where  names command and line, for messages
/// @throws InputError "where: found ...; expected ...", "where:/json/pointer: ...", or
///         "where:column: ..." for what is not JSON
Visit read_visit_line(std::string_view line, const std::string& where);

}  // namespace asterism
