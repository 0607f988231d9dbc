#pragma once

#include "axioms/axiom_set.hpp"
#include "cli/options.hpp"
#include "core/trace.hpp"

namespace asterism {

/// `asterism map --minimal`: searches for the minimal models, without a list of all maps.
/// @pre    the axioms are the shipped ones, and the native engine decides
/// @return exit code
int map_minimal(const MapCommand& command, const AxiomSet& axioms, const Trace& trace);

}  // namespace asterism
