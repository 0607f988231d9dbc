#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace asterism {

/// How many maps each visit leaves: all of them, and those that can be drawn in the plane. Either
/// list may be empty, or shorter than the trace where a run was stopped. Logarithmic where the
/// numbers go beyond a thousand. A standalone SVG 1.1.
std::string hypotheses_chart_svg(const std::string& title,
                                 const std::vector<std::uint64_t>& all_per_visit,
                                 const std::vector<std::uint64_t>& planar_per_visit);

}  // namespace asterism
