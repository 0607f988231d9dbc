#pragma once

#include <cstdint>

#include "core/trace.hpp"

namespace asterism {

/// A walk through a random world, a grid or corridors, of a few travels: the seed says which.
Trace random_trace(std::uint64_t seed);

/// The fifteen visits to the places of the building of the ACES log, in its order.
Trace ring_trace();

}  // namespace asterism
