#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/random.hpp"
#include "engine/ask/exits.hpp"
#include "simulation/walk.hpp"
#include "simulation/world.hpp"

namespace asterism {

/// How a robot goes on exploring.
enum class Explorer {
  advised,            ///< to the first exit that `exits` lists, all the way, then asks again
  random,             ///< out of any gateway, all alike
  nearest_unexplored  ///< by the shortest way to a gateway not yet used; it is told where it is
};

/// A robot in a world without blind stubs, after a random walk that left many maps.
struct Exploration {
  World world;
  Route route;         ///< walked so far
  std::uint64_t maps;  ///< that explain it
};

/// What a seed draws: a grid or a crowd of corridors, and a walk of 12 to 20 travels, the shortest
/// that leaves 20 to 5000 maps, not only planar ones. Nothing if it draws no such walk.
std::optional<Exploration> exploration(std::uint64_t seed);

/// Where so many more travels lead to.
struct Explored {
  std::uint64_t maps;
  std::size_t places;        ///< of the world, seen since the start
  std::size_t segments;      ///< travelled since the start
  std::size_t new_segments;  ///< ... and never before
};
/// @param bounds  of the exits that advice may name
Explored explore(const Exploration& start, Explorer explorer, bool planar, std::size_t travels,
                 RandomEngine& engine, const ExitBounds& bounds = {});

/// Of the logarithms of ratios.
struct MeanLogRatio {
  double mean;
  double half_width;  ///< of its 95 % interval
};
/// @pre  as many of each, at least two
MeanLogRatio mean_log_ratio(const std::vector<Explored>& ours, const std::vector<Explored>& theirs);

}  // namespace asterism
