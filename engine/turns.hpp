#pragma once

#include <cstddef>
#include <vector>

namespace asterism {

/// A row of travels. Each number is how many arms clockwise of the one come in by the robot leaves
/// a place, so 0 leads back; at a first visit that does not say, of the star's first arm.
using Turns = std::vector<std::size_t>;

}  // namespace asterism
