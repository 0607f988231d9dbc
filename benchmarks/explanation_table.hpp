#pragma once

#include <span>

#include "benchmarks/report.hpp"
#include "core/trace.hpp"

namespace asterism {

/// For every two visits that were to one place in no map, why not: how long that takes, all and
/// planar. Checks that these are the pairs that listing the maps finds.
void add_explanation_table(Report& report, std::span<const Trace> traces);

}  // namespace asterism
