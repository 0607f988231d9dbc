#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/trace.hpp"

namespace asterism {

/// An exploring walk, in a world whose size grows with it.
struct GrowingWalk {
  enum class In {
    grid,      ///< no corridor missing, without stubs: everything looks alike
    corridors  ///< at random angles, as crowded whatever their number
  };
  In in;
  std::size_t size;  ///< places in a row of the grid; corridors drawn
  std::size_t travels;
};

inline constexpr std::array<GrowingWalk, 8> grid_walks{{
    {GrowingWalk::In::grid, 3, 20},
    {GrowingWalk::In::grid, 4, 40},
    {GrowingWalk::In::grid, 5, 60},
    {GrowingWalk::In::grid, 6, 100},
    {GrowingWalk::In::grid, 7, 140},
    {GrowingWalk::In::grid, 8, 190},
    {GrowingWalk::In::grid, 9, 240},
    {GrowingWalk::In::grid, 10, 300},
}};

inline constexpr std::array<GrowingWalk, 8> corridor_walks{{
    {GrowingWalk::In::corridors, 4, 20},
    {GrowingWalk::In::corridors, 6, 30},
    {GrowingWalk::In::corridors, 10, 45},
    {GrowingWalk::In::corridors, 15, 70},
    {GrowingWalk::In::corridors, 22, 100},
    {GrowingWalk::In::corridors, 32, 150},
    {GrowingWalk::In::corridors, 45, 210},
    {GrowingWalk::In::corridors, 60, 300},
}};

/// @return a trace named by its size, as "6 × 6, 100 travels"
Trace make_trace(const GrowingWalk& walk, std::uint64_t seed);

}  // namespace asterism
