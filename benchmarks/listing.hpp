#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "benchmarks/process.hpp"
#include "core/trace.hpp"
#include "engine/tree/map_tree.hpp"

namespace asterism {

/// What one way of listing every map of a trace took.
struct Listing {
  std::optional<std::uint64_t> maps;  ///< absent: not all of them in the time given
  double wall_s = 0;
  double cpu_s = wall_s;  ///< below it where the machine was busy with other things
};

/// Grows a fresh tree by all visits in one pass, `runs` times; the median. The tree is made before
/// and goes after the time is taken.
Listing list_with_tree(const Trace& trace, const MapTree::Options& options, std::size_t runs);

/// A tree grown visit by visit, as online.
struct OnlineListing {
  Listing all;           ///< of all visits together, the median of the runs
  double slowest_s = 0;  ///< the visit that took longest, in the last run
  /// The most on any level with at least 1,000 hypotheses, if there is one: of MapTree itself, and
  /// of the heap while that level grew, what was there before the tree apart.
  std::optional<double> tree_bytes_each;
  std::optional<double> peak_bytes_each;
};
OnlineListing list_online(const Trace& trace, const MapTree::Options& options, std::size_t runs);

/// Other programs, each a process of its own, from start to end.
class Programs {
 public:
  /// @param asterism    the program
  /// @param benchmarks  the folder with maps.lp
  Programs(std::string asterism, std::string benchmarks)
      : asterism_(std::move(asterism)), benchmarks_(std::move(benchmarks)) {}

  bool has_clingo() const;
  /// clingo 0 -q OPTION maps.lp FACTS; the option may be empty.
  Listing clingo(const Trace& trace, const std::string& option, double time_limit_s) const;
  /// asterism map TRACE --certify 0, `runs` times; the median.
  Listing asterism(const Trace& trace, std::size_t runs) const;

 private:
  std::string asterism_;
  std::string benchmarks_;
  ScratchFolder scratch_;
};

}  // namespace asterism
