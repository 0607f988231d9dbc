#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "benchmarks/minimal_methods.hpp"
#include "benchmarks/report.hpp"

namespace asterism {

/// How much to run of the search for minimal models.
struct MinimalScale {
  MinimalLimits limits = {};
  std::size_t sizes = 8;    ///< of the walks that grow
  std::size_t seeds = 5;    ///< of each size
  double sweep_s = 3;       ///< for each search, where the walk grows and the grid does not
  double extending_s = 20;  ///< for the searches after all visits together
  std::size_t extended_walks = 2;
  std::size_t rounds = 9;  ///< of one, two and four threads in turn; fewer, but three, ...
  double threads_s = 40;   ///< ... where they take longer
};

/// MinimalSearch beside listing the tree, clingo and the solver, on walks that grow; then with
/// threads, and visit by visit. All must agree on what they prove.
/// @param benchmarks  the folder with maps.lp
/// @param picture     SVG file to draw the times in, if given
void add_minimal_tables(Report& report, const MinimalScale& scale, const std::string& benchmarks,
                        const std::optional<std::string>& picture);

}  // namespace asterism
