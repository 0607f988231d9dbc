#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "axioms/axiom_set.hpp"
#include "core/extents.hpp"
#include "core/trace.hpp"
#include "engine/arm_table.hpp"

namespace asterism {

/// The extents to minimise, in order of preference: the smaller rank is preferred.  [theory §6]
class Preference {
 public:
  using Rank = std::uint64_t;

  explicit Preference(const std::vector<Extent>& extents) : extents_(extents) {
    Rank weight = 1;
    for (auto extent = extents.rbegin(); extent != extents.rend(); ++extent, weight *= one_more)
      (*extent == Extent::path ? paths_ : *extent == Extent::place ? places_ : segments_) = weight;
    first_ = weight / one_more;
  }
  Rank rank(const Extents& extents) const {
    return paths_ * extents.paths + places_ * extents.places + segments_ * extents.segments;
  }
  /// The extent that counts most, of this rank.
  std::uint64_t first(Rank rank) const { return rank / first_; }
  /// The highest rank with so much of the extent that counts most.
  Rank highest(std::uint64_t first) const { return (first + 1) * first_ - 1; }
  const std::vector<Extent>& extents() const { return extents_; }

 private:
  static constexpr Rank one_more = Rank{1} << 21;  // than any extent: see ArmTable

  std::vector<Extent> extents_;
  Rank paths_ = 0;
  Rank places_ = 0;
  Rank segments_ = 0;
  Rank first_ = 1;
};

/// The sizes of what the axioms minimise, in the order of preference: to be compared as rows are.
/// Extents of the axioms' own are counted in the least closure of the hypothesis.
std::vector<std::size_t> extents_by_preference(const ArmTable& table, std::span<const ArmId> named,
                                               const AxiomSet& axioms);
std::vector<std::size_t> extents_by_preference(const Trace& trace, std::span<const Arrival> map,
                                               const AxiomSet& axioms);

/// Sizes of shipped extents, in the order of preference.
/// @pre  axioms.minimises_own() is false
template <class Map>
std::vector<std::size_t> extents_by_preference(const Map& map, const AxiomSet& axioms) {
  const Extents extents = extents_of(map);
  std::vector<std::size_t> result;
  for (const Extent extent : axioms.preference()) result.push_back(extents.of(extent));
  return result;
}

}  // namespace asterism
