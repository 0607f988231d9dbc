#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "axioms/axiom_set.hpp"
#include "core/extents.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"
#include "core/verdict.hpp"
#include "engine/ask/query.hpp"
#include "engine/proof/premise.hpp"

namespace asterism {

class MapProblem;

/// "There are at most so many places": an extent compared with a number.
Claim compare(Extent extent, Claim::Relation relation, std::size_t size);

/// Is there a map, of which all premises are true, that is wanted? The solver is asked for one
/// after another; those that are not wanted become excluded by the premises.
/// @param premises  with all visits
Verdict check_for(MapProblem& problem, std::vector<Premise>& premises,
                  const std::function<bool(std::span<const Arrival>)>& is_wanted);

/// Is there a map preferred to those of these extents? Of shipped extents the solver is told; of
/// the axioms' own it is not, and each map that it finds is counted, as check_for() does.
/// @param premises  with all visits
Verdict check_preferred_to(const std::vector<std::size_t>& extents, MapProblem& problem,
                           const Trace& trace, const AxiomSet& axioms,
                           std::vector<Premise>& premises);

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

}  // namespace asterism
