#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/trace.hpp"

namespace asterism {

/// A simulated trace with a known number of maps: an exploring walk through a 4 × 4 grid, a tenth
/// of its corridors missing, a tenth of the gaps blind stubs.
struct BenchmarkTrace {
  const char* name;
  std::uint64_t seed;
  std::size_t travels;
  std::uint64_t consistent;  ///< hypotheses after the last visit
};

inline constexpr std::array<BenchmarkTrace, 4> benchmark_traces{{
    {"grid-10^3", 333, 24, 1'005},
    {"grid-10^4", 311, 40, 10'614},
    {"grid-10^5", 263, 40, 100'122},
    {"grid-10^6", 36, 40, 1'001'950},
}};

Trace make_trace(const BenchmarkTrace& benchmark);

}  // namespace asterism
