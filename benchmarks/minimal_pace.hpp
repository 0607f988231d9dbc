#pragma once

#include <span>

#include "benchmarks/minimal_growth.hpp"
#include "benchmarks/minimal_table.hpp"
#include "benchmarks/report.hpp"

namespace asterism {

/// Which walks are proved as soon as they should be, and how many times as long clingo takes.
void add_aims_table(Report& report, std::span<const GrowthRow> grids);

/// One, two and four threads in turn, on those of the walks that took longest; the models must be
/// the same.
void add_threads_table(Report& report, const MinimalScale& scale, std::span<const GrowthRow> grids);

/// A search extended visit by visit, beside a fresh one after each visit.
void add_extending_table(Report& report, const MinimalScale& scale);

}  // namespace asterism
