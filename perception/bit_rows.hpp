#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/grid.hpp"

namespace asterism {

/// A picture whose cells are set or not, row by row, 64 cells in a word: the lowest bit is the
/// westernmost. No cell outside the picture is ever set. Threads may read one that none changes.
class BitRows {
 public:
  /// 64 cells side by side.
  using Word = std::uint64_t;

  BitRows() = default;
  /// A picture without a set cell.
  BitRows(int width, int height);

  int width() const noexcept { return width_; }    ///< columns
  int height() const noexcept { return height_; }  ///< rows
  int words() const noexcept { return words_; }    ///< of a row

  /// Whether a cell lies in the picture.
  bool contains(Cell cell) const {
    return cell.column >= 0 && cell.row >= 0 && cell.column < width_ && cell.row < height_;
  }
  /// Whether a cell is set; none outside the picture is.
  bool has(Cell cell) const {
    return contains(cell) && (word(cell.row, cell.column / 64) >> cell.column % 64 & 1U) != 0;
  }
  /// @pre contains(cell)
  void set(Cell cell) { word(cell.row, cell.column / 64) |= Word{1} << cell.column % 64; }
  /// @pre contains(cell)
  void clear(Cell cell) { word(cell.row, cell.column / 64) &= ~(Word{1} << cell.column % 64); }
  /// Sets the cells of a row from `first` up to and without `past`.
  void set_run(int row, int first, int past);

  /// A word of a row. Rows -1 to height() and words -1 to words() may be read: round the picture
  /// nothing is set.
  Word word(int row, int i) const { return bits_[index(row, i)]; }
  /// A word of a row, to write to.   @pre it lies in the picture
  Word& word(int row, int i) { return bits_[index(row, i)]; }
  /// Of each cell of a word, its western neighbour.
  Word west_of(int row, int i) const { return word(row, i) << 1U | word(row, i - 1) >> 63U; }
  /// Of each cell of a word, its eastern neighbour.
  Word east_of(int row, int i) const { return word(row, i) >> 1U | word(row, i + 1) << 63U; }
  /// The cells of a word that lie in the picture.
  Word inside(int i) const {
    return i == words_ - 1 && width_ % 64 != 0 ? (Word{1} << width_ % 64) - 1 : ~Word{0};
  }

  /// Calls `visit` with each set cell, row by row from the bottom.
  template <typename Visit>
  void for_each(Visit visit) const {
    for (int row = 0; row < height_; ++row) {
      for (int i = 0; i < words_; ++i) {
        for (Word left = word(row, i); left != 0; left &= left - 1) {
          visit(Cell{64 * i + std::countr_zero(left), row});
        }
      }
    }
  }

  friend bool operator==(const BitRows&, const BitRows&) = default;

 private:
  std::size_t index(int row, int i) const {
    return static_cast<std::size_t>((row + 1) * (words_ + 2) + i + 1);
  }

  int width_ = 0;
  int height_ = 0;
  int words_ = 0;
  std::vector<Word> bits_;
};

/// The connected pieces of a picture, numbered from 0 in the order of their first cells, row by
/// row. A value: threads may read one side by side.
class Pieces {
 public:
  enum class Touch { sides, corners };  ///< 4-connected or 8-connected

  /// Set cells of a row, from `first` up to and without `past`, none set on either side.
  struct Run {
    int row = 0;
    int first = 0;
    int past = 0;
    std::size_t piece = 0;
  };

  /// Finds the pieces; the picture is not kept.
  Pieces(const BitRows& picture, Touch touch);

  /// How many pieces there are.
  std::size_t count() const noexcept { return count_; }
  const std::vector<Run>& runs() const noexcept { return runs_; }  ///< row by row
  /// The piece of a cell; nothing where it is not set.
  std::optional<std::size_t> at(Cell cell) const;

 private:
  std::vector<Run> runs_;
  std::vector<std::size_t> row_start_;  ///< first run of each row, and of the one above all
  std::size_t count_ = 0;
};

}  // namespace asterism
