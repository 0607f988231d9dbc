#pragma once

#include <compare>
#include <cstddef>
#include <span>
#include <vector>

#include "core/topological_map.hpp"
#include "core/trace.hpp"

namespace asterism {

/// A plain enumerator of maps, written apart from everything else so that it can judge the rest. It
/// knows core's data, none of its functions but Star's arms, opposite ones included in its own way.
struct BruteForceOptions {
  bool planar = false;        ///< V - E + F = 2                                     [theory §7]
  bool one_segment = false;   ///< two places are joined by at most one segment      [theory §5]
  bool one_crossing = false;  ///< two paths meet at most once                       [theory §5]
};

using Association = std::vector<Arrival>;

/// Whether this data association is consistent with the visits it covers: tested whole, against
/// [theory §3-§5, §7]   @pre  places are numbered by first visit
bool is_consistent(const Trace& trace, const Association& association,
                   const BruteForceOptions& options);

/// Every consistent data association of the trace, sorted. Tries every partition of the visits
/// into places with every choice of arms, and tests each when it is whole: about 7 visits.
std::vector<Association> every_map(const Trace& trace, const BruteForceOptions& options = {});

/// The same, visit by visit: level k has the associations of the first k+1 visits, sorted. Extends
/// those of the level before in every way and tests each from scratch: goes much deeper.
std::vector<std::vector<Association>> every_map_by_visit(const Trace& trace,
                                                         const BruteForceOptions& options = {});

}  // namespace asterism
