#include "perception/free_space.hpp"

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstddef>
#include <utility>

namespace asterism {
namespace {

using Word = BitRows::Word;

// What is known of each cell.
void classify(const Grid& grid, float known, BitRows& free, BitRows& occupied) {
  for (int row = 0; row < grid.height; ++row) {
    for (int i = 0; i < free.words(); ++i) {
      const float* const log_odds = grid.log_odds.data() + grid.index({64 * i, row});
      const int cells = std::min(64, grid.width - 64 * i);
      Word is_free = 0;
      Word is_occupied = 0;
      for (int bit = 0; bit < cells; ++bit) {
        is_free |= Word{log_odds[bit] <= -known} << bit;
        is_occupied |= Word{log_odds[bit] >= known} << bit;
      }
      free.word(row, i) = is_free;
      occupied.word(row, i) = is_occupied;
    }
  }
}

// Unknown cells with free ones at most two cells away on two opposite sides, nothing occupied
// between, are gaps between beams: free.
void fill_gaps(BitRows& free, const BitRows& occupied) {
  // Cells that are free, or unknown with a free one next to them, in one direction.
  const auto reached = [&](int row, int i, int right, int up) {
    if (row < 0 || row >= free.height() || i < 0 || i >= free.words()) return Word{0};
    const Word unknown = ~free.word(row, i) & ~occupied.word(row, i) & free.inside(i);
    const Word next = right == 0   ? free.word(row + up, i)
                      : right == 1 ? free.east_of(row + up, i)
                                   : free.west_of(row + up, i);
    return free.word(row, i) | (unknown & next);
  };
  const auto towards = [&](int row, int i, int right, int up) {
    const Word own = reached(row + up, i, right, up);
    if (right == 0) return own;
    const Word beside = reached(row + up, i + right, right, up);
    return right == 1 ? own >> 1U | beside << 63U : own << 1U | beside >> 63U;
  };
  constexpr std::array<std::array<int, 2>, 4> lines{{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};
  BitRows filled = free;
  for (int row = 0; row < free.height(); ++row) {
    for (int i = 0; i < free.words(); ++i) {
      const Word unknown = ~free.word(row, i) & ~occupied.word(row, i) & free.inside(i);
      if (unknown == 0) continue;
      Word gaps = 0;
      for (const auto& [right, up] : lines) {
        gaps |= towards(row, i, right, up) & towards(row, i, -right, -up);
      }
      filled.word(row, i) |= unknown & gaps;
    }
  }
  free = std::move(filled);
}

// Takes out the islands: 8-connected pieces of what is not free that touch no edge of the grid.
void take_out_islands(BitRows& free, BitRows& occupied, double resolution_m, double island_max_m) {
  BitRows others(free.width(), free.height());
  for (int row = 0; row < free.height(); ++row) {
    for (int i = 0; i < free.words(); ++i) {
      others.word(row, i) = ~free.word(row, i) & free.inside(i);
    }
  }
  const Pieces pieces(others, Pieces::Touch::corners);
  struct Extent {
    Cell low = {INT_MAX, INT_MAX};
    Cell high = {-1, -1};
  };
  std::vector<Extent> extents(pieces.count());
  for (const Pieces::Run& run : pieces.runs()) {
    auto& [low, high] = extents[run.piece];
    low = {std::min(low.column, run.first), std::min(low.row, run.row)};
    high = {std::max(high.column, run.past - 1), std::max(high.row, run.row)};
  }
  const auto is_island = [&](const Extent& extent) {
    const auto& [low, high] = extent;
    const bool at_edge = low.column == 0 || low.row == 0 || high.column == free.width() - 1 ||
                         high.row == free.height() - 1;
    const int across = std::max(high.column - low.column, high.row - low.row) + 1;
    return !at_edge && resolution_m * across <= island_max_m;
  };
  for (const Pieces::Run& run : pieces.runs()) {
    if (is_island(extents[run.piece])) free.set_run(run.row, run.first, run.past);
  }
  for (int row = 0; row < free.height(); ++row) {
    for (int i = 0; i < free.words(); ++i) occupied.word(row, i) &= ~free.word(row, i);
  }
}

// One line of the distance transform: d[q] = min over p of (q − p)² + f[p], as the lower envelope
// of parabolas.  [FH12, §2.1]
class Envelope {
 public:
  explicit Envelope(int longest)
      : f_(static_cast<std::size_t>(longest)),
        apex_(static_cast<std::size_t>(longest)),
        from_(static_cast<std::size_t>(longest) + 1) {}

  float& f(int q) { return f_[static_cast<std::size_t>(q)]; }

  // Transforms f(0) to f(count - 1) and writes all but the first and the last.
  void transform(int count, float* inner) {
    std::size_t last = 0;
    apex_[0] = 0;
    from_[0] = -1e9F;
    for (int q = 1; q < count; ++q) {
      const float own = f(q) + static_cast<float>(q * q);
      float start = 0;
      for (;; --last) {
        const int p = apex_[last];
        start = (own - f(p) - static_cast<float>(p * p)) / static_cast<float>(2 * (q - p));
        if (start > from_[last]) break;
      }
      ++last;
      apex_[last] = q;
      from_[last] = start;
    }
    from_[last + 1] = static_cast<float>(count);
    std::size_t at = 0;
    for (int q = 1; q + 1 < count; ++q) {
      while (from_[at + 1] < static_cast<float>(q)) ++at;
      const int p = apex_[at];
      inner[q - 1] = static_cast<float>((q - p) * (q - p)) + f(p);
    }
  }

 private:
  std::vector<float> f_;
  std::vector<int> apex_;
  std::vector<float> from_;
};

// Each run of set cells is a line of its own: of what lies beyond the cells at its ends nothing is
// nearer than those.
std::vector<float> squared_distances(int width, int height, const std::vector<Pieces::Run>& runs) {
  const auto index = [width](int row, int column) {
    return static_cast<std::size_t>(row * width + column);
  };
  // Along the columns two sweeps over the set cells do.
  std::vector<float> squared(index(height, 0), 0);
  const auto sweep = [&](const Pieces::Run& run, int from, bool shorten) {
    for (int column = run.first; column < run.past; ++column) {
      const bool outside = from < 0 || from >= height;
      const float away = 1 + (outside ? 0 : squared[index(from, column)]);
      float& own = squared[index(run.row, column)];
      own = shorten ? std::min(own, away) : away;
    }
  };
  for (auto run = runs.begin(); run != runs.end(); ++run) sweep(*run, run->row - 1, false);
  for (auto run = runs.rbegin(); run != runs.rend(); ++run) sweep(*run, run->row + 1, true);

  Envelope envelope(width + 2);
  for (const Pieces::Run& run : runs) {
    const int count = run.past - run.first;
    float* const line = squared.data() + index(run.row, run.first);
    envelope.f(0) = 0;
    for (int i = 0; i < count; ++i) envelope.f(i + 1) = line[i] * line[i];
    envelope.f(count + 1) = 0;
    envelope.transform(count + 2, line);
  }
  return squared;
}

}  // namespace

std::vector<float> squared_distances(const BitRows& picture) {
  const Pieces pieces(picture, Pieces::Touch::sides);
  return squared_distances(picture.width(), picture.height(), pieces.runs());
}

FreeSpace free_space(const Grid& grid, const FreeSpaceOptions& options) {
  FreeSpace space{.frame = frame_of(grid),
                  .free = BitRows(grid.width, grid.height),
                  .occupied = BitRows(grid.width, grid.height)};
  classify(grid, static_cast<float>(options.known), space.free, space.occupied);
  fill_gaps(space.free, space.occupied);
  take_out_islands(space.free, space.occupied, grid.resolution_m, options.island_max_m);

  space.clearance_m = squared_distances(space.free);
  const auto resolution_m = static_cast<float>(grid.resolution_m);
  space.free.for_each([&](Cell cell) {
    float& clearance_m = space.clearance_m[grid.index(cell)];
    clearance_m = (std::sqrt(clearance_m) - 0.5F) * resolution_m;
  });
  return space;
}

}  // namespace asterism
