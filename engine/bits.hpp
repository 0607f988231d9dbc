#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace asterism {

// Sets of arms or visits, as the hot loops keep them: rows of words, a bit an id.

inline constexpr std::size_t bits_a_word = 64;

/// Words in a row with a bit for each of so many ids.
constexpr std::size_t words_for(std::size_t ids) { return (ids + bits_a_word - 1) / bits_a_word; }
/// In which word of its row an id has its bit.
template <class Id>
constexpr std::size_t word_of(Id id) {
  return id.index() / bits_a_word;
}
/// The bit of an id in that word.
template <class Id>
constexpr std::uint64_t bit_of(Id id) {
  return std::uint64_t{1} << (id.index() % bits_a_word);
}

/// The ids in one word of a row, in order.
template <class Id>
class IdsInWord {
 public:
  struct End {};
  class Iterator {
   public:
    constexpr Iterator(std::size_t first, std::uint64_t bits) : first_(first), bits_(bits) {}
    constexpr Id operator*() const {
      return Id(first_ + static_cast<std::size_t>(std::countr_zero(bits_)));
    }
    constexpr Iterator& operator++() {
      bits_ &= bits_ - 1;
      return *this;
    }
    friend constexpr bool operator==(Iterator at, End) { return at.bits_ == 0; }

   private:
    std::size_t first_;
    std::uint64_t bits_;
  };

  /// @param word  its position in the row
  constexpr IdsInWord(std::size_t word, std::uint64_t bits) : word_(word), bits_(bits) {}
  constexpr Iterator begin() const { return Iterator(word_ * bits_a_word, bits_); }
  constexpr End end() const { return {}; }

 private:
  std::size_t word_;
  std::uint64_t bits_;
};

}  // namespace asterism
