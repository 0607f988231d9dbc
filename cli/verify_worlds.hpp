#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <span>

#include "cli/verify_report.hpp"

namespace asterism {

/// A walk through a random world, a grid or corridors, of a few travels: the seed says which.
Trace random_trace(std::uint64_t seed);

/// Compares native engine and solver at every candidate of every trace, all maps and planar ones,
/// where the native engine knows the axioms; counts paths, places and segments of every map in the
/// least closure of the axioms, and has minimal models certified. Ends at the first difference.
EnginesFinding compare_engines(const AxiomSet& axioms, std::span<const Trace> traces,
                               std::chrono::steady_clock::time_point deadline);

/// Compares what axioms say, and which hypotheses of the traces they leave, with the shipped ones.
ChangeFinding compare_with_shipped(const AxiomSet& axioms, std::span<const Trace> traces,
                                   std::chrono::steady_clock::time_point deadline);

}  // namespace asterism
