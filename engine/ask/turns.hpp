#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "core/trace.hpp"

namespace asterism {

/// A row of travels. Each number is how many arms clockwise of the one come in by the robot leaves
/// a place, so 0 leads back; at a first visit that does not say, of the star's first arm.
using Turns = std::vector<std::size_t>;

/// The row of turns by which a search came to one of those it reached, from the first of them.
/// @param reached  each names the one `before` it, by number, and the `turn` from there
template <class Reached>
Turns turns_to(const std::vector<Reached>& reached, std::size_t number) {
  Turns turns;
  for (; number > 0; number = reached[number].before) turns.push_back(reached[number].turn);
  std::ranges::reverse(turns);
  return turns;
}

/// The name of the arm by which a row of travels leaves the visit it begins at.  @pre  it is not
/// empty
inline std::string first_arm(const Visit& visit, const Turns& turns) {
  return visit.star.name(visit.star.clockwise(visit.entered_by.value_or(0), turns.front()));
}

/// The travels after the first.  @pre  there is one
inline Turns further(const Turns& turns) { return {turns.begin() + 1, turns.end()}; }

}  // namespace asterism
