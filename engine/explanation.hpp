#pragma once

#include <optional>
#include <span>
#include <vector>

#include "axioms/axiom_set.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"
#include "core/verdict.hpp"
#include "engine/map_problem.hpp"
#include "engine/query.hpp"

namespace asterism {

/// How a map cannot be drawn: a travel leaves into a face and would have to come in from another.
struct Crossing {
  VisitId visit;  ///< where the travel ends
  PlaceArm left, entered;
  std::vector<TopologicalMap::Segment> segments;  ///< that cannot be drawn together
  std::vector<PlaceArm> face;  ///< that the travel leaves into: gateways, as in faces()
  std::vector<std::vector<PlaceId>> loops;  ///< closed ways along its border: places, in order
};

/// Premises that cannot all be, none of which can be spared.
struct Explanation {
  struct Member {
    Premise premise;
    PartialMap without;  ///< a map that all the others allow
  };
  std::vector<Member> members;       ///< visits, axioms, planarity, claims
  std::optional<Crossing> crossing;  ///< in the map without planarity, where that is a member
};

/// Whether there is a map of which the claims are true, and what speaks for it or against.
struct Reason {
  Verdict verdict;
  PartialMap map;           ///< where *consistent*: all visits
  Explanation explanation;  ///< where *inconsistent*
};

/// Asks the solver whether some map of the trace makes all these claims true, and if none does, for
/// an irredundant set of premises that says so. A fresh solver has confirmed it.
///
/// Claims that can be spared are left out before anything else, the last first, then planarity,
/// visits, and the axioms from the last to the first: what stays is as elementary as it may be.
///
/// @param seconds  for all of it; past them the verdict is *undecided*
/// Paths and segments are counted by the closed form, also where an axiom is spared on which it
/// rests.
///
/// @throws std::logic_error if the fresh solver disagrees
Reason explain(const Trace& trace, const AxiomSet& axioms, bool planar,
               std::span<const Claim> claims, double seconds);

/// The first travel of a map that cannot be drawn, if there is one.
std::optional<Crossing> find_crossing(const Trace& trace, const PartialMap& map);

}  // namespace asterism
