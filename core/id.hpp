#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>

namespace asterism {

/// A position in one kind of list. Each kind is its own type, and turns into no other and into no
/// number unless told to; absence is std::optional. Plain data: threads may share it as they share
/// a number.
///
/// @tparam Number  what it is kept as: a small one where flat arrays hold many
template <class Tag, std::unsigned_integral Number = std::size_t>
class Id {
 public:
  /// @param index  from 0
  constexpr explicit Id(std::size_t index) noexcept : index_(static_cast<Number>(index)) {}
  /// The position, from 0.
  constexpr std::size_t index() const noexcept { return index_; }
  constexpr Id& operator++() noexcept {
    ++index_;
    return *this;
  }
  constexpr Id next() const noexcept { return Id(index_ + std::size_t{1}); }
  /// @pre it is not the first
  constexpr Id previous() const noexcept { return Id(index_ - std::size_t{1}); }
  friend constexpr auto operator<=>(Id, Id) noexcept = default;

 private:
  Number index_;
};

using VisitId = Id<struct VisitTag, std::uint32_t>;  ///< visits of a trace, from 0
using ArmId = Id<struct ArmTag, std::uint32_t>;      ///< arms of all its visits' stars, in a row
using ViewId = Id<struct ViewTag, std::uint32_t>;    ///< different stars as seen on arrival
using PlaceId = Id<struct PlaceTag>;                 ///< places of a map, by first visit
using PathId = Id<struct PathTag>;                   ///< paths of a map, by smallest arm
using HypothesisId = Id<struct HypothesisTag>;       ///< hypotheses of one level of the tree

/// Ids in a row: for (const ArmId arm : table.arms(visit)).
template <class I>
class IdRange {
 public:
  class Iterator {
   public:
    using value_type = I;
    using difference_type = std::ptrdiff_t;

    constexpr explicit Iterator(I at) noexcept : at_(at) {}
    constexpr I operator*() const noexcept { return at_; }
    constexpr Iterator& operator++() noexcept {
      ++at_;
      return *this;
    }
    friend constexpr bool operator==(Iterator, Iterator) noexcept = default;

   private:
    I at_;
  };

  /// From the first to the one before `end`.
  constexpr IdRange(I first, I end) noexcept : first_(first), end_(end) {}
  /// The first so many.
  constexpr explicit IdRange(std::size_t size) noexcept : IdRange(I(0), I(size)) {}

  constexpr Iterator begin() const noexcept { return Iterator(first_); }
  constexpr Iterator end() const noexcept { return Iterator(end_); }

 private:
  I first_;
  I end_;
};

}  // namespace asterism
