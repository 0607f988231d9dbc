#pragma once

#include <array>
#include <filesystem>

#include "io/picture/report_page.hpp"
#include "mapping/log_maps.hpp"

namespace asterism {

/// What the files of a log are called that belong to no model alone.
inline constexpr std::array log_file_names{"log.trace.json", "maps.json", "report.html"};

/// What the page of a run shows of the maps of a log.
RunReport run_report_of(LogMaps maps);

/// Writes all that a log says into a folder: log.trace.json with the maps of its places in log.lpm,
/// maps.json, report.html, and the files of each ranked map, those of the first in the folder
/// itself, of the others in model-2, model-3 ... A model that no file can hold, as where places lie
/// out of all bounds, is left out, and remarked on the page.
/// @return  what the page shows
/// @throws Error if it cannot
RunReport write_log_files(const std::filesystem::path& folder, LogMaps maps);

}  // namespace asterism
