#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/any_trace.hpp"

namespace asterism {

/// Of a file that is read.
inline constexpr std::size_t max_trace_bytes = std::size_t{64} << 20;

/// Reads a trace file.                                                             [theory §2]
///
/// Strict: beside what theory.md says, each arm has at most one measured gateway, scans are at most
/// 2^53 - 1, and a covariance is symmetric and positive semi-definite up to rounding (1e-9,
/// relative to the variances). The displacement of the first visit is checked like any other: a
/// trace may be a piece of a longer one.
///
/// @param file_name  for messages
/// @throws InputError "file:/json/pointer: found ...; expected ..."; for what is not JSON
///         "file:line:column: ..."; for a trace of the basic SSH, which has no stars
Trace read_trace(std::string_view json_text, const std::string& file_name);

/// Reads a trace file from the disk.
/// @throws InputError as read_trace, and if the file cannot be read or exceeds max_trace_bytes
Trace read_trace_file(const std::string& file);

/// Reads a trace file of either kind. In an experience, views are not empty and not called like
/// actions, so that a view or an action left out is found.
/// @throws InputError as read_trace
AnyTrace read_any_trace(std::string_view json_text, const std::string& file_name);

/// Reads a trace file of either kind from the disk.
/// @throws InputError as read_trace, and if the file cannot be read or exceeds max_trace_bytes
AnyTrace read_any_trace_file(const std::string& file);

/// The trace as a file's content, one visit to a line or, where it was measured, a few. Reads back
/// as the same trace.
/// @throws std::invalid_argument if the trace could not be read back
std::string trace_json(const Trace& trace);

/// The experience as a file's content, a view and an action to a line. Reads back as the same.
/// @throws std::invalid_argument if it could not be read back
std::string trace_json(const Experience& experience);

/// Writes a trace file, whole or not at all.
/// @throws std::invalid_argument as trace_json, Error if the file cannot be written
void write_trace_file(const std::string& file, const Trace& trace);

}  // namespace asterism
