#pragma once

#include <compare>
#include <cstddef>

namespace asterism {

/// A position in one kind of list. Each kind is its own type; absence is std::optional.
template <class Tag>
class Id {
 public:
  constexpr explicit Id(std::size_t index) noexcept : index_(index) {}
  constexpr std::size_t index() const noexcept { return index_; }
  friend constexpr auto operator<=>(Id, Id) noexcept = default;

 private:
  std::size_t index_;
};

using VisitId = Id<struct VisitTag>;            ///< visits of a trace, from 0
using PlaceId = Id<struct PlaceTag>;            ///< places of a map, by first visit
using PathId = Id<struct PathTag>;              ///< paths of a map, by smallest arm
using HypothesisId = Id<struct HypothesisTag>;  ///< hypotheses of one level of the tree

}  // namespace asterism
