#pragma once

#include <span>
#include <string>

#include "core/scan.hpp"
#include "core/trace.hpp"

namespace asterism {

class JsonNode;

// 64 bits, FNV-1a, in hexadecimal: against mistakes, not against malice.

/// Of the text of a trace's file.
std::string digest(const Trace& trace);
/// Of all that scans tell.
std::string digest(std::span<const Scan> scans);

/// A digest in a file.
/// @throws InputError if it is none
std::string read_digest(const JsonNode& node);

}  // namespace asterism
