#pragma once

#include <string>

#include "core/run_report.hpp"

namespace asterism {

// The parts of a report's page; each is XML, and empty where there is nothing to show.

/// The page's style sheet.
std::string report_style();

/// One sentence: how many maps explain the trace, which was chosen, how sure.
std::string verdict_sentence(const RunReport& report);

/// The paths of a map with their colours and their places in order.
std::string path_list(const TopologicalMap& map);

/// Ranked models side by side.
std::string models_section(const RunReport& report);

/// The visits as a table, and what was seen on each as a picture.
std::string visits_section(const RunReport& report);

/// Places, alignments and displacements of each model, in numbers.
std::string measures_section(const RunReport& report);

}  // namespace asterism
