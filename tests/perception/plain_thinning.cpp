#include "tests/perception/plain_thinning.hpp"

#include <array>
#include <cstddef>
#include <utility>

namespace asterism {
namespace {

class Board {
 public:
  Board(const Picture& picture, int width, int height)
      : picture_(picture), width_(width), height_(height) {}

  bool contains(int column, int row) const {
    return column >= 0 && row >= 0 && column < width_ && row < height_;
  }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(column);
  }
  int at(int column, int row) const {
    return contains(column, row) && picture_[index(column, row)] != 0 ? 1 : 0;
  }

 private:
  const Picture& picture_;
  int width_;
  int height_;
};

bool goes(const Board& board, int column, int row, bool second) {
  if (board.at(column, row) == 0) return false;
  // P2 ... P9 run clockwise from the north; rows run upwards.
  const int p2 = board.at(column, row + 1);
  const int p3 = board.at(column + 1, row + 1);
  const int p4 = board.at(column + 1, row);
  const int p5 = board.at(column + 1, row - 1);
  const int p6 = board.at(column, row - 1);
  const int p7 = board.at(column - 1, row - 1);
  const int p8 = board.at(column - 1, row);
  const int p9 = board.at(column - 1, row + 1);

  const int b = p2 + p3 + p4 + p5 + p6 + p7 + p8 + p9;
  if (b < 2 || b > 6) return false;

  const std::array<int, 9> round{p2, p3, p4, p5, p6, p7, p8, p9, p2};
  int a = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    if (round[i] == 0 && round[i + 1] == 1) ++a;
  }
  if (a != 1) return false;

  if (second) return p2 * p4 * p8 == 0 && p2 * p6 * p8 == 0;
  return p2 * p4 * p6 == 0 && p4 * p6 * p8 == 0;
}

}  // namespace

BitRows bit_rows(const Picture& picture, int width, int height) {
  BitRows rows(width, height);
  const Board board(picture, width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      if (board.at(column, row) != 0) rows.set({column, row});
    }
  }
  return rows;
}

Picture picture_of(const BitRows& rows) {
  Picture picture;
  for (int row = 0; row < rows.height(); ++row) {
    for (int column = 0; column < rows.width(); ++column) {
      picture.push_back(rows.has({column, row}));
    }
  }
  return picture;
}

std::vector<Picture> plain_thinning(const Picture& picture, int width, int height) {
  std::vector<Picture> stages{picture};
  for (bool changed = true; changed;) {
    changed = false;
    for (const bool second : {false, true}) {
      Picture next = stages.back();
      const Board board(stages.back(), width, height);
      for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
          if (goes(board, column, row, second)) next[board.index(column, row)] = 0;
        }
      }
      if (next == stages.back()) continue;
      changed = true;
      stages.push_back(std::move(next));
    }
  }
  return stages;
}

std::vector<int> pieces_of(const Picture& picture, int width, int height, bool figure) {
  const Board board(picture, width, height);
  std::vector<int> piece(picture.size(), 0);
  int pieces = 0;
  std::vector<std::pair<int, int>> reached;
  const auto reach = [&](int column, int row) {
    if (!board.contains(column, row) || (board.at(column, row) != 0) != figure) return;
    int& own = piece[board.index(column, row)];
    if (own != 0) return;
    own = pieces;
    reached.emplace_back(column, row);
  };
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      if ((board.at(column, row) != 0) != figure || piece[board.index(column, row)] != 0) continue;
      ++pieces;
      reach(column, row);
      while (!reached.empty()) {
        const auto [x, y] = reached.back();
        reached.pop_back();
        for (int up = -1; up <= 1; ++up) {
          for (int right = -1; right <= 1; ++right) {
            if (figure || up == 0 || right == 0) reach(x + right, y + up);
          }
        }
      }
    }
  }
  return piece;
}

}  // namespace asterism
