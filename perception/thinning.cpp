#include "perception/thinning.hpp"

#include <array>
#include <cstddef>

namespace asterism {
namespace {

using Word = std::uint64_t;

// Rows of bits, framed by an empty row below and above and an empty word at both sides.
class Bits {
 public:
  Bits(int width, int height)
      : words_((static_cast<std::size_t>(width) + 63) / 64 + 2),
        bits_(words_ * (static_cast<std::size_t>(height) + 2), 0) {}

  std::size_t words() const { return words_; }
  Word& word(std::size_t row, std::size_t word) { return bits_[row * words_ + word]; }
  Word left_of(std::size_t row, std::size_t word) {  // each cell's western neighbour
    return this->word(row, word) << 1U | this->word(row, word - 1) >> 63U;
  }
  Word right_of(std::size_t row, std::size_t word) {
    return this->word(row, word) >> 1U | this->word(row, word + 1) << 63U;
  }

 private:
  std::size_t words_;
  std::vector<Word> bits_;
};

// Bits set in two or more of the words.
template <std::size_t Count>
Word two_of(const std::array<Word, Count>& words, Word flipped) {
  Word once = 0;
  Word twice = 0;
  for (const Word word : words) {
    twice |= once & (word ^ flipped);
    once |= word ^ flipped;
  }
  return twice;
}

// The cells of one word that a subiteration takes away. P2 ... P9 run clockwise from the north.
Word removable(const std::array<Word, 8>& p, bool second) {
  std::array<Word, 8> steps{};  // 0-1 patterns in the order P2, P3, ..., P9, P2
  Word any = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    steps[i] = ~p[i] & p[(i + 1) % 8];
    any |= steps[i];
  }
  const Word one_step = any & ~two_of(steps, 0);               // A(P1) = 1
  const Word two_to_six = two_of(p, 0) & two_of(p, ~Word{0});  // 2 ≤ B(P1) ≤ 6
  const auto [p2, p4, p6, p8] = std::array{p[0], p[2], p[4], p[6]};
  const Word sides = second ? ~(p2 & p4 & p8) & ~(p2 & p6 & p8)   // (c'), (d')
                            : ~(p2 & p4 & p6) & ~(p4 & p6 & p8);  // (c), (d)
  return one_step & two_to_six & sides;
}

// One subiteration; whether anything went.
bool peel(Bits& bits, std::size_t height, bool second, std::vector<Word>& gone) {
  bool changed = false;
  const std::size_t inner = bits.words() - 2;
  gone.assign(inner * height, 0);
  for (std::size_t row = 1; row <= height; ++row) {
    for (std::size_t word = 1; word <= inner; ++word) {
      const Word own = bits.word(row, word);
      if (own == 0) continue;
      const std::array<Word, 8> p{bits.word(row + 1, word), bits.right_of(row + 1, word),
                                  bits.right_of(row, word), bits.right_of(row - 1, word),
                                  bits.word(row - 1, word), bits.left_of(row - 1, word),
                                  bits.left_of(row, word),  bits.left_of(row + 1, word)};
      const Word away = own & removable(p, second);
      gone[(row - 1) * inner + word - 1] = away;
      changed |= away != 0;
    }
  }
  for (std::size_t i = 0; changed && i < gone.size(); ++i) {
    bits.word(i / inner + 1, i % inner + 1) &= ~gone[i];
  }
  return changed;
}

}  // namespace

std::vector<std::uint8_t> thinned(const std::vector<std::uint8_t>& picture, int width, int height) {
  const auto columns = static_cast<std::size_t>(width);
  const auto rows = static_cast<std::size_t>(height);
  Bits bits(width, height);
  for (std::size_t i = 0; i < picture.size(); ++i) {
    if (picture[i]) bits.word(i / columns + 1, i % columns / 64 + 1) |= Word{1} << i % columns % 64;
  }
  std::vector<Word> gone;
  for (bool changed = true; changed;) {
    changed = peel(bits, rows, false, gone);
    changed = peel(bits, rows, true, gone) || changed;
  }
  std::vector<std::uint8_t> lines(picture.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lines[i] = bits.word(i / columns + 1, i % columns / 64 + 1) >> i % columns % 64 & 1U;
  }
  return lines;
}

}  // namespace asterism
