#pragma once

#include <string>

#include "core/run_report.hpp"

namespace asterism {

/// The ranked models, a line each, and which place each visit of the first is at.
std::string ranking_text(const RunReport& report);

}  // namespace asterism
