#pragma once

#include <optional>
#include <span>
#include <vector>

#include "axioms/theory.hpp"
#include "core/stop.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"
#include "core/verdict.hpp"
#include "engine/ask/query.hpp"
#include "engine/proof/premise.hpp"
#include "engine/proof/sketch.hpp"

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
struct Clash {
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
  PartialMap map;  ///< where *consistent*: all visits
  Clash clash;     ///< where *inconsistent*
};

/// Asks the solver whether some map of the trace makes all these claims true, and if none does, for
/// an irredundant set of premises that says so. A fresh solver has confirmed it.
///
/// Claims that can be spared are left out before anything else, the last first, then planarity,
/// visits, and the axioms from the last to the first: what stays is as elementary as it may be.
///
/// Paths and segments are counted by the closed form, also where an axiom is spared on which it
/// rests. What the theory assumes are the first claims.
///
/// @param stop  its deadline is for all of it; past it the verdict is *undecided*
/// @throws std::logic_error if the fresh solver disagrees
Reason explain(const Trace& trace, const Theory& theory, std::span<const Claim> claims,
               const Stop& stop = {});

/// Asks in that way whether a data association explains the visits it tells of. Where it does not,
/// a visit among the premises stands for where it was as well, and is nothing without the visit to
/// whose place it was.
///
/// @param candidate  for a prefix of the trace, places numbered by first visit
/// @throws std::logic_error if the fresh solver disagrees
Reason explain_candidate(const Trace& trace, const Theory& theory,
                         std::span<const Arrival> candidate, const Stop& stop = {});

/// The first travel of a map that cannot be drawn, if there is one.
std::optional<Crossing> find_crossing(const Trace& trace, const PartialMap& map);

}  // namespace asterism
