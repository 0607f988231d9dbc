#pragma once

#include <span>
#include <vector>

#include "axioms/theory.hpp"
#include "core/stop.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"

namespace asterism {

enum class Certificate {
  shown,      ///< the solver agrees: these are models, and nothing is preferred to them
  not_shown,  ///< it did not say in the time given
  refuted     ///< it disagrees: a fault
};

/// Has the solver certify minimal models: each satisfies axioms and trace, and "a consistent
/// (planar) map strictly preferred to these", data association left free, is unsatisfiable.
///                                                                             [theory §8]
///
/// The second is put to a MapProblem: no star matching and no tree takes part. Of extents that the
/// axioms declare, the solver is asked for one map after another, and each is counted.
///
/// What is assumed is asked of both: the models hold it, and so must what would be preferred.
///
/// @param models  data associations of the minimal models; at least one
/// @param stop    its deadline is for all of it
Certificate certify(const Trace& trace, const Theory& theory,
                    std::span<const std::vector<Arrival>> models, const Stop& stop = {});

}  // namespace asterism
