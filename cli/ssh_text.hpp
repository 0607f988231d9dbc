#pragma once

#include <string>

#include "core/ssh_report.hpp"

namespace asterism {

/// The report in words: counts, and at most this many of its maps.
std::string report_text(const SshReport& report, std::size_t most_maps);

}  // namespace asterism
