#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include "core/topological_map.hpp"

namespace asterism {

/// What a query may ask, told a second way: from the segments of a map written out, by closing
/// relations until nothing is added, as the axioms have them.                       [theory §5]
class QueryReference {
 public:
  explicit QueryReference(const TopologicalMap& map);

  bool same(std::size_t i, std::size_t j) const { return place(i) == place(j); }
  bool adjacent(std::size_t i, std::size_t j) const;
  bool on_path(std::size_t i, std::size_t j) const;
  /// The place of visit i is on the path faced on leaving visit j.
  bool on(std::size_t i, std::size_t j) const;
  bool order(std::size_t i, std::size_t j, std::size_t k) const;
  bool same_path(std::size_t i, std::size_t j) const;
  std::size_t steps(std::size_t i, std::size_t j) const;
  std::size_t places() const { return map_.places.size(); }
  std::size_t paths() const;
  std::size_t segments() const { return map_.segments.size(); }

 private:
  std::size_t place(std::size_t visit) const { return map_.visits[visit].index(); }
  std::size_t number(PlaceArm arm) const;
  PlaceArm opposite(PlaceArm arm) const;
  bool is_on(std::size_t place, std::size_t path) const;

  const TopologicalMap& map_;
  std::vector<PlaceArm> arms_;
  std::vector<std::size_t> path_;      ///< of each arm: the least arm linked to it
  std::vector<std::size_t> directed_;  ///< the same without turning around
  std::set<std::tuple<std::size_t, std::size_t, std::size_t>> before_;  ///< directed path, places
};

}  // namespace asterism
