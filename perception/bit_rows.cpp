#include "perception/bit_rows.hpp"

#include <algorithm>

namespace asterism {
namespace {

// The runs of one row, from the west.
void add_runs(const BitRows& picture, int row, std::vector<Pieces::Run>& runs) {
  bool open = false;  // the last run reaches the end of the word before
  for (int i = 0; i < picture.words(); ++i) {
    const BitRows::Word word = picture.word(row, i);
    for (int at = 0; at < 64;) {
      const int same = open ? std::countr_one(word >> at) : std::countr_zero(word >> at);
      const int next = std::min(64, at + same);
      if (open) runs.back().past = 64 * i + next;
      at = next;
      if (at == 64) break;
      open = !open;
      if (open) runs.push_back({.row = row, .first = 64 * i + at, .past = 64 * i + at});
    }
  }
}

// The first run of the piece that a run is in so far; the way there is shortened.
std::size_t first_of(std::vector<std::size_t>& before, std::size_t run) {
  while (before[run] != run) run = before[run] = before[before[run]];
  return run;
}

}  // namespace

BitRows::BitRows(int width, int height)
    : width_(width),
      height_(height),
      words_((width + 63) / 64),
      bits_(static_cast<std::size_t>((words_ + 2) * (height + 2)), 0) {}

void BitRows::set_run(int row, int first, int past) {
  for (int i = first / 64; 64 * i < past; ++i) {
    const int low = std::max(first - 64 * i, 0);
    const int high = std::min(past - 64 * i, 64);
    word(row, i) |= ~Word{0} >> (64 - (high - low)) << low;
  }
}

Pieces::Pieces(const BitRows& picture, Touch touch) {
  const int reach = touch == Touch::corners ? 1 : 0;
  std::vector<std::size_t> before;  // an earlier run of the same piece, or the run itself
  row_start_.push_back(0);
  for (int row = 0; row < picture.height(); ++row) {
    add_runs(picture, row, runs_);
    std::size_t below = row == 0 ? 0 : row_start_[row_start_.size() - 2];
    const std::size_t start = row_start_.back();
    for (std::size_t run = start; run < runs_.size(); ++run) {
      before.push_back(run);
      while (below < start && runs_[below].past + reach <= runs_[run].first) ++below;
      for (std::size_t other = below; other < start && runs_[other].first < runs_[run].past + reach;
           ++other) {
        const std::size_t a = first_of(before, run);
        const std::size_t b = first_of(before, other);
        before[std::max(a, b)] = std::min(a, b);
      }
    }
    row_start_.push_back(runs_.size());
  }
  for (std::size_t run = 0; run < runs_.size(); ++run) {
    const std::size_t first = first_of(before, run);
    runs_[run].piece = first == run ? count_++ : runs_[first].piece;
  }
}

std::optional<std::size_t> Pieces::at(Cell cell) const {
  if (cell.row < 0 || cell.row + 1 >= static_cast<int>(row_start_.size())) return std::nullopt;
  const auto row = static_cast<std::size_t>(cell.row);
  for (std::size_t run = row_start_[row]; run < row_start_[row + 1]; ++run) {
    if (cell.column < runs_[run].past) {
      return cell.column < runs_[run].first ? std::nullopt : std::optional(runs_[run].piece);
    }
  }
  return std::nullopt;
}

}  // namespace asterism
