#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "core/map_report.hpp"
#include "engine/map_tree.hpp"
#include "engine/minimal_search.hpp"

namespace asterism {

/// Grows the tree by the whole trace. In one pass where nothing can stop it early, since that is
/// the fastest; else visit by visit, to end on a whole level.
/// @return  what stopped it, if anything did
std::optional<std::string> grow(MapTree& tree, const Trace& trace, const MapCommand& command,
                                Progress& progress);

/// Why the whole tree was not decided, where the solver owes answers.
std::string undecided_text(const MapTree& tree);

/// Whether the solver certifies the minimal models, if it is to, in the time left.
/// @throws std::logic_error if it refutes them and may not
bool is_certified(const Trace& trace, const std::vector<std::vector<Arrival>>& models,
                  const MapCommand& command, const AxiomSet& axioms, Progress& progress,
                  bool may_be_refuted = false);

/// What a grown tree says of a trace, its minimal models certified if there is time for it.
/// @throws std::logic_error if the solver refutes them
MapReport report_of(const MapTree& tree, const MapCommand& command, const AxiomSet& axioms,
                    std::optional<std::string> stopped_by, Progress& progress);

/// The same of a search for the minimal models. One that was stopped has none to report.
MapReport report_of(const MinimalSearch& search, const MapCommand& command, const AxiomSet& axioms,
                    std::optional<std::string> stopped_by, Progress& progress);

/// How many maps each visit leaves, under the other view on planarity: for the chart, whose curve
/// ends where there would be too many for a picture.
std::vector<std::uint64_t> other_counts(const MapCommand& command, const AxiomSet& axioms,
                                        const Trace& trace);

/// What a search knows so far.
MapReport::Bounds bounds_of(const MinimalSearch& search);

}  // namespace asterism
