#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "engine/minimal/minimal_search.hpp"
#include "engine/tree/map_tree.hpp"

namespace asterism {

using Models = std::vector<std::vector<Arrival>>;

/// A walk through a random world, of a kind the seed says: grids and corridors, stubs and dead
/// ends, round one face or about, out and back, stars disguised or not, the first visit entered by
/// some gateway or none. It ends before there are more maps than `most_maps`, so that the tree of
/// all of them can judge a search.
Trace small_trace(unsigned seed, std::uint64_t most_maps);

/// A walk through a grid, too long for a tree: tens of thousands of branchings.
Trace long_trace(unsigned seed, std::size_t side, std::size_t travels);

/// The walk, and the same way back.
Trace retraced(Trace trace);

/// The shipped axioms, these extents minimised.
AxiomSet preferring(const std::vector<std::string>& order);

/// A search for all there is to know.
MinimalSearch searched(const Trace& trace, MinimalSearch::Options options);
inline MinimalSearch searched(const Trace& trace, bool planar) {
  return searched(trace, {.theory = {.planar = planar}});
}

}  // namespace asterism
