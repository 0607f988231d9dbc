#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "benchmarks/listing.hpp"
#include "benchmarks/report.hpp"
#include "core/trace.hpp"

namespace asterism {

/// A trace with known numbers of maps.
struct KnownCase {
  Trace trace;
  std::uint64_t all;
  std::optional<std::uint64_t> planar;
};

/// How much to run.
struct Scale {
  std::size_t runs = 15;                   ///< of what takes milliseconds; the median counts
  double time_limit_s = 600;               ///< of clingo and of Z3 blocking models, each time
  std::uint64_t most_clingo = UINT64_MAX;  ///< maps of a trace that clingo is given
  std::uint64_t most_z3 = 2000;            ///< the same for Z3 blocking models
};

/// Every map of a trace: the native engine beside clingo, Z3 blocking models and the whole program.
void add_listing_table(Report& report, const Scale& scale, const Programs& programs,
                       std::span<const KnownCase> cases);

/// All and planar maps, in one pass and visit by visit, and the memory they take.
void add_online_table(Report& report, const Scale& scale, std::span<const KnownCase> cases);

/// Native engine, solver and both, and how long certification takes.
void add_solver_table(Report& report, const Scale& scale, std::span<const KnownCase> cases);

}  // namespace asterism
