#include "perception/free_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace asterism {
namespace {

constexpr int kGap = 2;  // cells

// Takes out the islands: 8-connected pieces of what is not free that touch no edge of the grid.
void take_out_islands(FreeSpace& space, double island_max_m) {
  const Grid& frame = space.frame;
  std::vector<std::uint8_t> seen(space.cells.size(), 0);
  std::vector<Cell> piece;
  for (int row = 0; row < frame.height; ++row) {
    for (int column = 0; column < frame.width; ++column) {
      const std::size_t at = frame.index({column, row});
      if (seen[at] || space.cells[at] == Occupancy::free) continue;
      seen[at] = 1;
      piece.assign(1, {column, row});
      Cell low{column, row};
      Cell high = low;
      for (std::size_t next = 0; next < piece.size(); ++next) {
        const Cell cell = piece[next];
        low = {std::min(low.column, cell.column), std::min(low.row, cell.row)};
        high = {std::max(high.column, cell.column), std::max(high.row, cell.row)};
        for (int up = -1; up <= 1; ++up) {
          for (int right = -1; right <= 1; ++right) {
            const Cell other{cell.column + right, cell.row + up};
            if (!frame.contains(other)) continue;
            const std::size_t there = frame.index(other);
            if (seen[there] || space.cells[there] == Occupancy::free) continue;
            seen[there] = 1;
            piece.push_back(other);
          }
        }
      }
      const bool at_edge = low.column == 0 || low.row == 0 || high.column == frame.width - 1 ||
                           high.row == frame.height - 1;
      const double across_m =
          frame.resolution_m * (std::max(high.column - low.column, high.row - low.row) + 1);
      if (at_edge || across_m > island_max_m) continue;
      for (const Cell cell : piece) space.cells[frame.index(cell)] = Occupancy::free;
    }
  }
}

// Unknown cells with free ones close by on two opposite sides are gaps between beams: free.
void fill_gaps(FreeSpace& space) {
  const Grid& frame = space.frame;
  const std::vector<Occupancy> seen = space.cells;
  const auto free_towards = [&](Cell cell, int right, int up) {
    for (int step = 1; step <= kGap; ++step) {
      const Cell next{cell.column + step * right, cell.row + step * up};
      if (!frame.contains(next) || seen[frame.index(next)] == Occupancy::occupied) return false;
      if (seen[frame.index(next)] == Occupancy::free) return true;
    }
    return false;
  };
  constexpr std::array<std::array<int, 2>, 4> lines{{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};
  for (int row = 0; row < frame.height; ++row) {
    for (int column = 0; column < frame.width; ++column) {
      const Cell cell{column, row};
      Occupancy& own = space.cells[frame.index(cell)];
      if (own != Occupancy::unknown) continue;
      for (const auto& [right, up] : lines) {
        if (free_towards(cell, right, up) && free_towards(cell, -right, -up)) {
          own = Occupancy::free;
          break;
        }
      }
    }
  }
}

// One line of the distance transform: d[q] = min over p of (q − p)² + f[p], as the lower envelope
// of parabolas.  [FH12, §2.1]
class Envelope {
 public:
  explicit Envelope(int longest)
      : apex_(static_cast<std::size_t>(longest)), from_(static_cast<std::size_t>(longest) + 1) {}

  template <typename Read, typename Write>
  void transform(int count, Read f, Write write) {
    int last = -1;
    for (int q = 0; q < count; ++q) {
      const float own = f(q) + static_cast<float>(q * q);
      float start = 0;
      while (last >= 0) {
        const int p = apex_[static_cast<std::size_t>(last)];
        start = (own - f(p) - static_cast<float>(p * p)) / static_cast<float>(2 * (q - p));
        if (start > from_[static_cast<std::size_t>(last)]) break;
        --last;
      }
      ++last;
      apex_[static_cast<std::size_t>(last)] = q;
      from_[static_cast<std::size_t>(last)] = last == 0 ? -1e9F : start;
    }
    int at = 0;
    for (int q = 0; q < count; ++q) {
      while (at < last && from_[static_cast<std::size_t>(at) + 1] < static_cast<float>(q)) ++at;
      const int p = apex_[static_cast<std::size_t>(at)];
      write(q, static_cast<float>((q - p) * (q - p)) + f(p));
    }
  }

 private:
  std::vector<int> apex_;
  std::vector<float> from_;
};

}  // namespace

std::vector<float> squared_distances(const std::vector<std::uint8_t>& marked, int width,
                                     int height) {
  const auto columns = static_cast<std::size_t>(width);
  const float none = static_cast<float>(2 * (width + height)) * static_cast<float>(width + height);
  std::vector<float> squared(marked.size());
  // Along the rows two sweeps do.
  for (int row = 0; row < height; ++row) {
    const std::size_t start = static_cast<std::size_t>(row) * columns;
    int away = width + height;
    for (std::size_t i = start; i < start + columns; ++i) {
      away = marked[i] ? 0 : away + 1;
      squared[i] = away > width ? none : static_cast<float>(away * away);
    }
    away = width + height;
    for (std::size_t i = start + columns; i-- > start;) {
      away = marked[i] ? 0 : away + 1;
      if (away <= width) squared[i] = std::min(squared[i], static_cast<float>(away * away));
    }
  }
  Envelope envelope(height);
  std::vector<float> line(static_cast<std::size_t>(height));
  for (std::size_t column = 0; column < columns; ++column) {
    for (std::size_t row = 0; row < line.size(); ++row) line[row] = squared[row * columns + column];
    envelope.transform(
        height, [&](int q) { return line[static_cast<std::size_t>(q)]; },
        [&](int q, float value) {
          squared[static_cast<std::size_t>(q) * columns + column] = value;
        });
  }
  return squared;
}

FreeSpace free_space(const Grid& grid, const FreeSpaceOptions& options) {
  FreeSpace space;
  space.frame = {.width = grid.width,
                 .height = grid.height,
                 .resolution_m = grid.resolution_m,
                 .frame_from_grid = grid.frame_from_grid};
  space.cells.reserve(grid.log_odds.size());
  const auto known = static_cast<float>(options.known);
  for (const float log_odds : grid.log_odds) {
    space.cells.push_back(log_odds <= -known  ? Occupancy::free
                          : log_odds >= known ? Occupancy::occupied
                                              : Occupancy::unknown);
  }
  fill_gaps(space);
  take_out_islands(space, options.island_max_m);

  // One cell more on each side, marked: what lies outside is not free.
  const int width = grid.width + 2;
  const int height = grid.height + 2;
  std::vector<std::uint8_t> blocked(
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 1);
  const auto inner = [&](std::size_t at) {
    const auto columns = static_cast<std::size_t>(grid.width);
    return (at / columns + 1) * static_cast<std::size_t>(width) + at % columns + 1;
  };
  for (std::size_t at = 0; at < space.cells.size(); ++at) {
    if (space.cells[at] == Occupancy::free) blocked[inner(at)] = 0;
  }
  const std::vector<float> squared = squared_distances(blocked, width, height);
  space.clearance_m.resize(space.cells.size(), 0);
  for (std::size_t at = 0; at < space.cells.size(); ++at) {
    if (space.cells[at] != Occupancy::free) continue;
    space.clearance_m[at] =
        (std::sqrt(squared[inner(at)]) - 0.5F) * static_cast<float>(grid.resolution_m);
  }
  return space;
}

}  // namespace asterism
