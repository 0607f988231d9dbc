#pragma once

#include <span>
#include <string>
#include <vector>

#include "benchmarks/minimal_series.hpp"
#include "benchmarks/minimal_table.hpp"
#include "benchmarks/minimal_traces.hpp"
#include "benchmarks/time_chart.hpp"
#include "core/theory_record.hpp"

namespace asterism {

/// What the methods made of walks of one size.
struct GrowthRow {
  GrowingWalk walk;
  TheoryRecord theory;
  MinimalRuns search;  ///< of seeds 1, 2 ...
  MinimalRuns tree;
  MinimalRuns clingo;
  MinimalRuns solver;
};
std::string name_of(const GrowthRow& row);

/// Walks that grow, all maps and planar ones, a row of the table each.
std::vector<GrowthRow> add_growth_table(Report& report, const MinimalScale& scale,
                                        std::span<const GrowingWalk> walks,
                                        const std::string& benchmarks);
TimeRow growth_chart(const std::string& title, std::span<const GrowthRow> rows);

/// Grids that stay as they are, and walks that grow.
TimeRow add_sweep_table(Report& report, const MinimalScale& scale);

}  // namespace asterism
