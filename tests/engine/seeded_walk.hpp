#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/tree/map_tree.hpp"
#include "simulation/walk.hpp"
#include "tests/support/brute_force.hpp"

namespace asterism {

/// Stops work once it is asked and `go_on`, told how far it is, says no.
template <class F>
Stop stop_unless(F go_on) {
  return {.watch = [go_on = std::move(go_on)](const Standing& now) mutable {
    bool goes_on = true;
    if constexpr (std::is_invocable_v<F&, const Standing&>)
      goes_on = go_on(now);
    else
      goes_on = go_on();
    return goes_on ? std::nullopt : std::optional<std::string>("test");
  }};
}

/// A walk through a random world, grid or corridors; the seed says which.
Walk seeded_walk(unsigned seed, std::size_t travels);

/// What a failing test prints: the seed, and the trace, to be kept as
/// tests/traces/red-<seed>.trace.json.
std::string to_keep(unsigned seed, const Trace& trace);

/// The shipped axioms with these optional ones, preferred as (path place), read once.
const AxiomSet& shipped_with(const std::string& optional = "");

/// The tree grown by the whole trace.  @throws std::logic_error if growth stops early
MapTree tree_of(const Trace& trace, MapTree::Options options);
inline MapTree tree_of(const Trace& trace, bool planar) {
  return tree_of(trace, {.theory = {.axioms = shipped_with(), .planar = planar}});
}

/// Every hypothesis of the tree, sorted.
std::vector<Association> maps_of(const MapTree& tree);
/// The minimal ones, sorted.
std::vector<Association> minimal_of(const MapTree& tree);

}  // namespace asterism
