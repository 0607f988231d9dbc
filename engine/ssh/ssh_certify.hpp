#pragma once

#include <span>

#include "axioms/theory.hpp"
#include "core/ssh_map.hpp"
#include "core/stop.hpp"
#include "engine/proof/certify.hpp"

namespace asterism {

/// Has the solver certify minimal models of an experience of the basic SSH, as certify() does those
/// of a trace.                                                                      [theory §8]
///
/// The search for a preferred map: at(k, j) says that view k was seen at the dstate first
/// experienced at view j, which is new if j = k; exactly one holds for each k. Dstates at one place
/// (on one path) are a relation that grows with each turn (each travel and turn-around); there are
/// as many places (paths) as new dstates less the steps that joined two. An extent of segments is
/// not bounded, but counted on the map that a solution stands for.
///
/// @param models  the minimal models; at least one
/// @param stop    its deadline is for all of it
Certificate certify(const Experience& experience, const Theory& theory,
                    std::span<const SshMap> models, const Stop& stop = {});

}  // namespace asterism
