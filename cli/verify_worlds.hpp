#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "cli/verify_report.hpp"
#include "core/deadline.hpp"
#include "engine/map_tree.hpp"

namespace asterism {

using Association = std::vector<Arrival>;

inline constexpr const char* by_time_limit = "time limit";

/// Trees that stop at the deadline, and where there are more maps than can be compared.
MapTree::Options verify_tree_options(const AxiomSet& axioms, Check check, bool planar,
                                     Deadline deadline);

/// The hypotheses of a tree, sorted.
std::vector<Association> associations_of(const MapTree& tree);

/// A walk through a random world, a grid or corridors, of a few travels: the seed says which.
Trace random_trace(std::uint64_t seed);

/// The fifteen visits to the places of the building of the ACES log, in its order.
Trace ring_trace();

/// Compares native engine and solver at every candidate of every trace, all maps and planar ones,
/// where the native engine knows the axioms; counts paths, places and segments of every map in the
/// least closure of the axioms, and has minimal models certified. Ends at the first difference.
/// @param progress  told how many traces are done
EnginesFinding compare_engines(const AxiomSet& axioms, std::span<const Trace> traces,
                               Deadline deadline, const std::function<void(std::size_t)>& progress);

/// Compares what axioms say, and which hypotheses of the traces they leave, with the shipped ones.
ChangeFinding compare_with_shipped(const AxiomSet& axioms, std::span<const Trace> traces,
                                   Deadline deadline,
                                   const std::function<void(std::size_t)>& progress);

}  // namespace asterism
