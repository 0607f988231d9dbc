#pragma once

#include <vector>

#include "axioms/axiom_set.hpp"
#include "core/assumption.hpp"

namespace asterism {

/// What is asked of every map of a trace.
struct Theory {
  AxiomSet axioms = AxiomSet::shipped();
  bool planar = false;  ///< it can be drawn in the plane                            [theory §7]
  /// What is known beside the trace; one that names a visit to come holds from then on.
  std::vector<Assumption> assumptions = {};
};

}  // namespace asterism
