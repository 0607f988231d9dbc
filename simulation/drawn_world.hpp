#pragma once

#include <stdexcept>
#include <string>

#include "simulation/world.hpp"

namespace asterism {

/// The first world that has segments and enough places, of those drawn one after another.
///
/// @param draw      draws a world
/// @param what      what is drawn, in the message
/// @param expected  what would help, in the message
/// @throws std::invalid_argument if there was none in a thousand draws
template <class Draw>
World drawn_world(std::size_t min_places, Draw draw, const std::string& what,
                  const std::string& expected) {
  constexpr int draws = 1000;
  for (int i = 0; i < draws; ++i) {
    World world = draw();
    if (!world.segments.empty() && world.places.size() >= min_places) return world;
  }
  throw std::invalid_argument("found no " + what + " of " + std::to_string(min_places) +
                              " places in " + std::to_string(draws) + " draws; expected " +
                              expected);
}

}  // namespace asterism
