#pragma once

#include <string>

#include "core/run_report.hpp"

namespace asterism {

/// The page: one file that needs no other and runs no script, HTML as well as XML, for screens of
/// any width and for paper. Ranks are counted from 1, as the models' folders are.
///
/// Same report, same bytes.
/// @pre    all numbers are finite, all grids filled
/// @throws std::invalid_argument if a model explains more visits than there are, or its layout has
///         not one pose a place
std::string run_report_html(const RunReport& report);

}  // namespace asterism
