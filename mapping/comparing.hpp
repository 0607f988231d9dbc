#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "axioms/theory.hpp"
#include "core/stop.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"
#include "engine/tree/map_tree.hpp"
#include "io/json/verification_json.hpp"

namespace asterism {

// What verification compares on traces. Each is told how many traces are done.

/// Where each visit was, and by which arm it was entered: a data association.
using Association = std::vector<Arrival>;

/// What stopped a comparison, in its findings.
inline constexpr const char* by_time_limit = "time limit";

/// Trees that stop where there are more maps than can be compared.
MapTree::Options verify_tree_options(const Theory& theory, Check check);

/// The hypotheses of a tree, sorted.
std::vector<Association> associations_of(const MapTree& tree);

/// Why candidates of a tree are undecided: the time that the solver had was over, or it cannot say.
std::string why_undecided(const MapTree& tree, Deadline deadline);

/// Compares native engine and solver at every candidate of every trace, all maps and planar ones,
/// where the native engine knows the axioms; counts paths, places and segments of every map in the
/// least closure of the axioms, and has minimal models certified. Ends at the first difference.
EnginesFinding compare_engines(const AxiomSet& axioms, std::span<const Trace> traces,
                               Deadline deadline, const std::function<void(std::size_t)>& progress);

/// Compares what axioms say, and which hypotheses of the traces they leave, with the shipped ones.
ChangeFinding compare_with_shipped(const AxiomSet& axioms, std::span<const Trace> traces,
                                   Deadline deadline,
                                   const std::function<void(std::size_t)>& progress);

}  // namespace asterism
