#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/native.hpp"

namespace asterism {

/// The extents to minimise, in order of preference: the smaller rank is preferred.  [DESIGN §6]
class Preference {
 public:
  using Rank = std::uint64_t;

  explicit Preference(const std::vector<std::string>& extents) : extents_(extents) {
    Rank weight = 1;
    for (auto extent = extents.rbegin(); extent != extents.rend(); ++extent, weight *= one_more)
      (*extent == "path" ? paths_ : *extent == "place" ? places_ : segments_) = weight;
    first_ = weight / one_more;
  }
  Rank rank(const Extents& extents) const {
    return paths_ * extents.paths + places_ * extents.places + segments_ * extents.segments;
  }
  /// The extent that counts most, of this rank.
  std::uint64_t first(Rank rank) const { return rank / first_; }
  /// The highest rank with so much of the extent that counts most.
  Rank highest(std::uint64_t first) const { return (first + 1) * first_ - 1; }
  const std::vector<std::string>& extents() const { return extents_; }

 private:
  static constexpr Rank one_more = Rank{1} << 21;  // than any extent: see ArmTable

  std::vector<std::string> extents_;
  Rank paths_ = 0;
  Rank places_ = 0;
  Rank segments_ = 0;
  Rank first_ = 1;
};

}  // namespace asterism
