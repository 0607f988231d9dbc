#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "axioms/theory.hpp"
#include "core/stop.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"
#include "engine/minimal/minimal_search.hpp"
#include "engine/tree/map_tree.hpp"

namespace asterism {

/// Maps of a trace to be asked one after another, whoever found them; none is held by the list.
struct MapList {
  const Trace& trace;
  const Theory& theory;
  std::uint64_t size;
  /// Calls f for each, by its data association, until f returns false.
  std::function<void(const std::function<bool(std::span<const Arrival>)>& f)> for_each_while;
};

/// Every hypothesis of the tree, which must outlive the list.
MapList all_maps(const MapTree& tree);
/// Its minimal models.
MapList minimal_maps(const MapTree& tree);
/// The best maps found: the minimal models, if the search is complete. It must outlive the list.
MapList minimal_maps(const MinimalSearch& search);

}  // namespace asterism
