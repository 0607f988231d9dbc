#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "axioms/theory.hpp"
#include "core/map_report.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"
#include "mapping/trace_maps.hpp"

namespace asterism {

/// What explains a trace, or as much of it as can be explained.
struct ExplainedTrace {
  TraceMaps maps;                                   ///< of the visits explained
  MapReport report;                                 ///< of the whole trace
  std::vector<std::uint64_t> other_per_visit = {};  ///< maps under the other view on planarity
  std::string why = {};                             ///< no more is explained, where it is known
  /// Of each part that the trace is cut into, where no map explains all of it, but each part has
  /// some; none otherwise.
  std::vector<TraceMaps> parts = {};
};

/// Finds the maps of a trace, has the minimal models certified, and counts the maps under the other
/// view on planarity, where maps are counted. Where no map explains the trace, the maps are those
/// of the longest part of it, from the first visit, that one explains; and it is cut into the
/// fewest parts that are explained, where these can be found within a minute.
/// @throws std::logic_error if the solver refutes the minimal models
ExplainedTrace explain_trace(const Trace& trace, const Theory& theory, const MapOptions& options,
                             bool only_minimal, const MapWatch& watch = {});

/// Why no map of the visits so far explains the next: all of them hold a segment by which the robot
/// left, and that leads where something else is seen, or is assumed. Places are told by visits to
/// them.
/// @param map  of the visits so far
std::string why_no_more(const Trace& trace, const TopologicalMap& map, const Theory& theory);

}  // namespace asterism
