#pragma once

#include <cstdint>

#include "core/trace.hpp"

namespace asterism {

struct ModelCount {
  std::uint64_t models = 0;
  bool complete = false;  ///< false: the time ran out
};

/// Lists the maps of a trace as models of a propositional problem, that of maps.lp, each blocked by
/// a clause once it is found.
/// @pre  require_valid(trace) does not throw
ModelCount count_models_with_z3(const Trace& trace, double time_limit_s);

}  // namespace asterism
