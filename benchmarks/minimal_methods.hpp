#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>

#include "benchmarks/process.hpp"
#include "core/trace.hpp"

namespace asterism {

/// What a method knows of the minimal models of a trace when it ends.
struct MinimalResult {
  struct Size {
    std::uint64_t paths = 0;
    std::uint64_t places = 0;
    friend auto operator<=>(const Size&, const Size&) = default;
  };
  double seconds = 0;
  bool is_proved = false;                      ///< else it ran into a limit
  std::optional<std::uint64_t> at_least = {};  ///< paths, proved
  std::optional<Size> best = {};
  std::optional<std::uint64_t> count = {};  ///< of maps of this size
};

/// How long each method may take over a trace.
struct MinimalLimits {
  double search_s = 60;
  double tree_s = 20;
  std::uint64_t tree_maps = 20'000'000;
  double clingo_s = 60;
  double solver_s = 10;
};

/// MinimalSearch; what takes milliseconds is run some times, and the median counts.
MinimalResult search_minimal(const Trace& trace, bool planar, double limit_s);

/// The best of all maps, listed.
MinimalResult list_minimal(const Trace& trace, bool planar, const MinimalLimits& limits);

/// The solver, asked for better maps until there is none. Does not count them.
MinimalResult solve_minimal(const Trace& trace, bool planar, double limit_s);

/// clingo 0 -q --opt-mode=optN maps.lp minimal.lp FACTS, which knows nothing of planarity; in
/// processor time or the wall's, whichever is less. Proves no bound before the end.
/// @param benchmarks  the folder with maps.lp
MinimalResult clingo_minimal(const Trace& trace, double limit_s, const std::string& benchmarks,
                             const ScratchFolder& scratch);

}  // namespace asterism
