#include "perception/frontier.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace asterism {
namespace {

constexpr int direction_count = 120;

std::array<Point2, direction_count> all_directions() {
  std::array<Point2, direction_count> directions;
  for (int i = 0; i < direction_count; ++i) {
    directions[static_cast<std::size_t>(i)] =
        unit_vector(2 * std::numbers::pi * i / direction_count);
  }
  return directions;
}

BitRows frontier_cells(const FreeSpace& space) {
  BitRows cells(space.frame.width, space.frame.height);
  // Round the grid all is unknown.
  const auto unknown = [&](int row, int i) {
    if (row < 0 || row >= cells.height() || i < 0 || i >= cells.words()) return ~BitRows::Word{0};
    return ~space.free.word(row, i) & ~space.occupied.word(row, i);
  };
  for (int row = 0; row < cells.height(); ++row) {
    for (int i = 0; i < cells.words(); ++i) {
      const BitRows::Word free = space.free.word(row, i);
      if (free == 0) continue;
      const BitRows::Word own = unknown(row, i);
      cells.word(row, i) =
          free & (unknown(row - 1, i) | unknown(row + 1, i) | own << 1U |
                  unknown(row, i - 1) >> 63U | own >> 1U | unknown(row, i + 1) << 63U);
    }
  }
  return cells;
}

}  // namespace

Frontier::Frontier(const FreeSpace& space)
    : space_(space),
      sight_lines_(space),
      cells_(frontier_cells(space)),
      pieces_(cells_, Pieces::Touch::corners) {}

Frontier::Opening Frontier::opening_at(Cell end, double reach_m) const {
  static const std::array<Point2, direction_count> directions = all_directions();
  struct Hit {
    bool unknown = false;
    Point2 at = {};                     // the last free point
    std::optional<Cell> frontier = {};  // the last cell of it on the way
  };
  std::array<Hit, 2 * direction_count> hits;  // twice round
  const Point2 from = space_.frame.centre(end);
  const double step_m = sight_lines_.step_m();
  for (std::size_t i = 0; i < direction_count; ++i) {
    Hit& hit = hits[i];
    const SightLines::Line line = sight_lines_.line(from, directions[i]);
    for (int step = 0; step * step_m <= reach_m;) {
      const Cell cell = line.cell_at(step);
      if (!space_.is_free(cell)) {
        hit.unknown = !space_.occupied.has(cell);
        hit.at = from + ((step - 1) * step_m) * directions[i];
        break;
      }
      if (cells_.has(cell)) hit.frontier = cell;
      // Two steps less: the frontier lies one cell before the unknown.
      step += std::max(1, sight_lines_.stride(space_.clearance(cell)) - 2);
    }
    hits[i + direction_count] = hit;
  }

  Opening widest;
  for (std::size_t start = 0; start < direction_count; ++start) {
    if (!hits[start].unknown) continue;
    std::size_t last = start;
    while (last + 1 < start + direction_count && hits[last + 1].unknown) ++last;
    // Seen under a wide angle an opening is as wide as its rim is long.
    double width_m = 0;
    if (last - start > direction_count / 3) {
      for (std::size_t i = start; i < last; ++i) width_m += norm(hits[i + 1].at - hits[i].at);
    } else {
      width_m = norm(hits[last].at - hits[start].at);
    }
    if (width_m <= widest.width_m) continue;
    widest = {width_m, std::nullopt};
    for (std::size_t i = start; i <= last; ++i) {
      if (hits[i].frontier) widest.piece = pieces_.at(*hits[i].frontier);
    }
  }
  return widest;
}

}  // namespace asterism
