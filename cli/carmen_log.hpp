#pragma once

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>

#include "core/scan.hpp"

namespace asterism {

/// Hands out one scan after the other, then nothing.
using ScanSource = std::function<std::optional<Scan>()>;

/// Writes scans as a CARMEN log: FLASER lines, with PARAM lines before them that say how the beams
/// lie. All scans share one layout.
void write_carmen_log(std::ostream& out, const ScanSource& next);

/// Whole or not at all.  @throws Error if the file cannot be written
void write_carmen_log(const std::string& file, const ScanSource& next);

}  // namespace asterism
