#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/trace.hpp"

namespace asterism {

/// Counts on which programs written apart agree.                                  [theory §10]
struct KnownCounts {
  std::size_t consistent = 0;
  std::vector<std::size_t> per_visit;
  std::size_t minimal_paths = 0;
  std::size_t minimal_places = 0;
  std::vector<std::vector<std::size_t>> minimal_visits;  ///< place of each visit, sorted
};

struct KnownTrace {
  Trace trace;  ///< stars, arms entered and left by
  KnownCounts all;
  KnownCounts planar;
  std::vector<std::size_t> true_visits;
};

/// The traces of tests/traces/expected.json, by name.
std::vector<KnownTrace> known_traces();

}  // namespace asterism
