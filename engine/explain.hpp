#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axioms/axiom_set.hpp"
#include "axioms/axiom_solver.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"

namespace asterism {

/// Why a map cannot be.
struct Refutation {
  bool not_planar = false;          ///< planarity alone refutes it; else the axioms do
  std::vector<std::string> axioms;  ///< names, each once
  std::vector<Clash::Step> steps;   ///< instances of them; d3_1 is arm 1 of the place of visit 3
  std::vector<VisitId> visits;      ///< whose travels or stars take part
  std::vector<PlaceArm> arms;       ///< that take part
};

/// The reason why data association `child` (the last visit is where the child was dropped) does not
/// explain the trace: an irredundant set of axioms, found by the solver anew; or, where those
/// accept it, planarity, with the gateways of the segment that closes outside its face.
///
/// @param child  for a prefix of the trace
/// @return  nothing if it is consistent, or the solver did not say in time
std::optional<Refutation> explain_dropped(const Trace& trace, std::span<const Arrival> child,
                                          const AxiomSet& axioms, bool planar,
                                          unsigned timeout_ms = 10'000);

/// The grounded problem of a hypothesis as SMT-LIB 2 text: sat iff it is consistent.
std::string smt2_text(const Trace& trace, std::span<const Arrival> hypothesis,
                      const AxiomSet& axioms);

}  // namespace asterism
