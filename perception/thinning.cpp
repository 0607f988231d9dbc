#include "perception/thinning.hpp"

#include <array>
#include <vector>

namespace asterism {
namespace {

using Word = BitRows::Word;

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

// A word of the picture, and what a subiteration takes from it.
struct Loss {
  int row = 0;
  int word = 0;
  Word away = 0;
};

// One subiteration; whether anything went.
bool peel(BitRows& picture, const BitRows& anchors, bool second, std::vector<Loss>& losses) {
  losses.clear();
  for (int row = 0; row < picture.height(); ++row) {
    for (int i = 0; i < picture.words(); ++i) {
      const Word own = picture.word(row, i);
      if (own == 0) continue;
      const std::array<Word, 8> p{picture.word(row + 1, i), picture.east_of(row + 1, i),
                                  picture.east_of(row, i),  picture.east_of(row - 1, i),
                                  picture.word(row - 1, i), picture.west_of(row - 1, i),
                                  picture.west_of(row, i),  picture.west_of(row + 1, i)};
      Word away = own & removable(p, second);
      if (away != 0 && anchors.height() > 0) away &= ~anchors.word(row, i);
      if (away != 0) losses.push_back({row, i, away});
    }
  }
  for (const Loss& loss : losses) picture.word(loss.row, loss.word) &= ~loss.away;
  return !losses.empty();
}

}  // namespace

BitRows thinned(BitRows picture, const BitRows& anchors) {
  std::vector<Loss> losses;
  for (bool changed = true; changed;) {
    changed = peel(picture, anchors, false, losses);
    changed = peel(picture, anchors, true, losses) || changed;
  }
  return picture;
}

}  // namespace asterism
