#pragma once

#include <cstddef>

#include "benchmarks/report.hpp"

namespace asterism {

/// How many maps are left, and how much of the world was seen, after ten more travels by the advice
/// of `asterism next`, at random and to what is nearest unexplored, in the same worlds.
/// @pre  at least two worlds
void add_exploration_table(Report& report, std::size_t worlds);

}  // namespace asterism
