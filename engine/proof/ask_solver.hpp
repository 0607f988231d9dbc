#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axioms/theory.hpp"
#include "core/stop.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"
#include "core/verdict.hpp"
#include "engine/ask/query.hpp"

namespace asterism {

/// The solver counts paths and segments by the closed form: the axioms must keep every gateway to
/// one segment, and every path from closing on itself.
///                                                                             [theory §6]
/// @throws InputError if they do not, and the claim counts these
void require_countable(const Claim& claim, const std::string& text, const AxiomSet& axioms);

/// What the solver says to a query, without listing maps.
struct SolverAnswer {
  Verdict can_hold;  ///< in some map
  Verdict can_fail;
  std::optional<std::vector<Arrival>> witness = {};  ///< some map where it holds
  std::optional<std::vector<Arrival>> counterexample = {};

  /// Nothing where the solver did not say enough.
  std::optional<Modality> modality() const;
};

/// Asks all maps of a trace, or its minimal models, each query by two questions to the solver.
///
/// @param stop  its deadline is for all of it
/// @throws InputError if the queries name visits that the trace does not have, or see
///         require_countable()
std::vector<SolverAnswer> ask_solver(const Trace& trace, const Theory& theory,
                                     std::span<const Query> queries, bool only_minimal,
                                     const Stop& stop = {});

}  // namespace asterism
