#pragma once

#include <cstddef>
#include <vector>

namespace asterism {

/// Up to `capacity` units may flow from one vertex to another, at `cost` each.
struct FlowArc {
  std::size_t from = 0;
  std::size_t to = 0;
  long capacity = 0;
  long cost = 0;
};

/// What flows through a network, and what that costs.
struct Flow {
  std::vector<long> units;      ///< one an arc
  std::vector<long> potential;  ///< one a vertex: where cost + potential(from) - potential(to) is
                                ///< negative the arc is full, where positive it is empty
  long cost = 0;
};

/// The cheapest flow that takes `supply[v]` units out of every vertex v (into it, where negative).
/// Primal-dual: shortest paths by Dijkstra, then all augmentations along them.
///
/// @param potential  a start: only arcs of finite capacity may have a negative reduced cost; the
///                   closer to the final one, the faster
/// @pre    the supplies add up to 0
/// @throws std::logic_error if no flow meets the supplies
Flow cheapest_flow(const std::vector<FlowArc>& arcs, std::vector<long> supply,
                   std::vector<long> potential);

}  // namespace asterism
