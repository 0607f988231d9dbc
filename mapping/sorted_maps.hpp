#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/topological_map.hpp"
#include "engine/tree/map_tree.hpp"

namespace asterism {

/// All maps of a tree in the order of reports, by (visits, entered).                [theory §9]
class SortedMaps {
 public:
  /// @param tree  must outlive this
  explicit SortedMaps(const MapTree& tree);

  /// Held for each map, where the trace has so many visits.
  static std::size_t bytes(std::size_t visits) {
    return 2 * visits * sizeof(std::uint32_t) + sizeof(std::size_t);
  }

  /// Calls f with each map, the first first.
  void for_each(const std::function<void(const TopologicalMap&)>& f) const;

 private:
  std::span<const std::uint32_t> key(std::size_t i) const {
    return std::span(keys_).subspan(i * width_, width_);
  }

  const MapTree& tree_;
  std::size_t width_;
  std::vector<std::uint32_t> keys_;
  std::vector<std::size_t> order_;
};

}  // namespace asterism
