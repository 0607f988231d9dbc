#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axioms/axiom_set.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"
#include "core/verdict.hpp"
#include "engine/map_problem.hpp"
#include "engine/query.hpp"

namespace asterism {

/// "Preferred to a map of these extents": one is smaller, and those before it are no larger.
///                                                                             [DESIGN §6]
/// @param extents  sizes, in the order of preference
Claim preferred_to(const std::vector<std::size_t>& extents, const AxiomSet& axioms);

/// The sizes of a map's extents, in the order of preference.
std::vector<std::size_t> extents_by_preference(const TopologicalMap& map, const AxiomSet& axioms);

/// The solver counts paths and segments by the closed form: the axioms must keep every gateway to
/// one segment, and every path from closing on itself.
///                                                                             [DESIGN §6]
/// @throws InputError if they do not, and the claim counts these
void require_countable(const Claim& claim, const std::string& text, const AxiomSet& axioms);

/// The best map that a MapProblem allows.
struct Optimum {
  Verdict verdict;                   ///< undecided: none is known to be best
  std::vector<std::size_t> extents;  ///< of the best, in the order of preference
  std::vector<Arrival> map;          ///< one of them
};

/// Asks for better maps until there is none.
/// @param premises  with all visits
Optimum find_optimum(MapProblem& problem, const Trace& trace, const AxiomSet& axioms,
                     std::vector<Premise> premises);

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
/// @param given    claims that every map asked makes true
/// @param seconds  for all of it
/// @throws InputError if the queries name visits that the trace does not have, or see
///         require_countable()
std::vector<SolverAnswer> ask_solver(const Trace& trace, const AxiomSet& axioms, bool planar,
                                     std::span<const Claim> given, std::span<const Query> queries,
                                     bool only_minimal, double seconds);

}  // namespace asterism
