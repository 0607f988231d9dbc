#pragma once

#include <string>

#include "core/trace.hpp"

namespace asterism {

/// A trace as facts for maps.lp. Each visit may have founded a place, whose arms are numbered
/// through, in the order of the visit's star, visit after visit:
///
///     visit(K).       K > 0: a visit that ends a travel
///     arm(A, K).      arm A is of the place that visit K founds if it is a new one
///     opposite(A, B). the two directions of one local-path, both ways round
///     start(B).       the first visit leaves by arm B
///     arrive(K, A).   visit K matches the place of A at A; of its own arms, only the one entered
///     by depart(K, A, B).  where it arrived by A, it left by B
///
/// Matching is done here, since it depends on no map.                             [theory §3]
/// @pre  require_valid(trace) does not throw
std::string asp_facts(const Trace& trace);

}  // namespace asterism
