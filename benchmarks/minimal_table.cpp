#include "benchmarks/minimal_table.hpp"

#include <algorithm>
#include <span>

#include "benchmarks/minimal_growth.hpp"
#include "benchmarks/minimal_pace.hpp"
#include "io/atomic_file.hpp"

namespace asterism {

void add_minimal_tables(Report& report, const MinimalScale& scale, const std::string& benchmarks,
                        const std::optional<std::string>& picture) {
  const auto first = [&](std::span<const GrowingWalk> walks) {
    return walks.first(std::min(scale.sizes, walks.size()));
  };
  const auto grids = add_growth_table(report, scale, first(grid_walks), benchmarks);
  const auto corridors = add_growth_table(report, scale, first(corridor_walks), benchmarks);
  const TimeRow sweep = add_sweep_table(report, scale);
  add_aims_table(report, grids);
  add_threads_table(report, scale, grids);
  add_extending_table(report, scale);
  if (picture)
    write_atomically(
        *picture,
        time_chart_svg(
            "Time until all minimal models are proved",
            "open: ended by a limit, without proof; line up and down: from the fastest "
            "seed to the slowest",
            {growth_chart("Grids", grids), growth_chart("Random corridors", corridors), sweep}));
}

}  // namespace asterism
