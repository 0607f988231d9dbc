#include "perception/skeleton.hpp"

#include <cmath>
#include <limits>
#include <queue>

#include "perception/cells.hpp"
#include "perception/exits.hpp"
#include "perception/pruning.hpp"
#include "perception/thinning.hpp"

namespace asterism {
namespace {

// The cells with room for a gateway's half width, or where the robot was.
BitRows roomy_cells(const FreeSpace& space, double half_width_m, std::span<const Point2> driven) {
  const Grid& frame = space.frame;
  BitRows roomy(frame.width, frame.height);
  space.free.for_each([&](Cell cell) {
    if (space.clearance(cell) >= half_width_m) roomy.set(cell);
  });
  const SightLines sight_lines(space);
  for (const Point2 point : driven) {
    const Cell at = sight_lines.cell_at(point);
    if (space.is_free(at)) roomy.set(at);
    for (const Cell step : ring_steps) {
      if (space.is_free(at + step)) roomy.set(at + step);
    }
  }
  return roomy;
}

// The piece of the picture that is connected to its cell nearest the robot.
BitRows component(const BitRows& picture, Cell robot) {
  std::optional<Cell> nearest;
  if (picture.has(robot)) {
    nearest = robot;
  } else {
    picture.for_each([&](Cell cell) {
      if (!nearest || squared_distance(cell, robot) < squared_distance(*nearest, robot)) {
        nearest = cell;
      }
    });
  }
  BitRows result(picture.width(), picture.height());
  if (!nearest) return result;
  const Pieces pieces(picture, Pieces::Touch::sides);
  const std::size_t own = *pieces.at(*nearest);
  for (const Pieces::Run& run : pieces.runs()) {
    if (run.piece == own) result.set_run(run.row, run.first, run.past);
  }
  return result;
}

// Thinned diagonals may be two cells wide, and paths along them would cross over and back. Takes
// away, one by one, what is not needed to keep the lines 8-connected and is no end.
BitRows slimmed(const BitRows& lines) {
  BitRows slim = lines;
  lines.for_each([&](Cell cell) {
    std::array<bool, 8> on{};
    for (std::size_t i = 0; i < on.size(); ++i) on[i] = slim.has(cell + ring_steps[i]);
    int pieces = 0;
    for (std::size_t i = 0; i < on.size(); ++i) {
      const bool side = i % 2 == 0;
      pieces += side && !on[i] && (on[(i + 1) % 8] || on[(i + 2) % 8]);
    }
    if (pieces == 1 && !is_end(slim, cell)) slim.clear(cell);
  });
  return slim;
}

std::vector<SkeletonPoint> points_of(const BitRows& lines, const FreeSpace& space) {
  std::vector<SkeletonPoint> points;
  std::vector<std::size_t> before;  // how many points there are before each word of the lines
  for (int row = 0; row < lines.height(); ++row) {
    for (int i = 0; i < lines.words(); ++i) {
      before.push_back(points.size());
      for (BitRows::Word left = lines.word(row, i); left != 0; left &= left - 1) {
        const Cell cell{64 * i + std::countr_zero(left), row};
        points.push_back({.cell = cell, .radius_m = space.clearance(cell)});
      }
    }
  }
  const auto number = [&](Cell cell) {
    const int word = cell.column / 64;
    const BitRows::Word west = (BitRows::Word{1} << cell.column % 64) - 1;
    return before[static_cast<std::size_t>(cell.row * lines.words() + word)] +
           static_cast<std::size_t>(std::popcount(lines.word(cell.row, word) & west));
  };
  for (SkeletonPoint& point : points) {
    for (const Cell step : ring_steps) {
      if (lines.has(point.cell + step)) point.neighbours.add(number(point.cell + step));
    }
  }
  return points;
}

}  // namespace

Skeleton skeleton(const FreeSpace& space, Cell robot, const SkeletonOptions& options,
                  std::span<const Point2> driven) {
  const Grid& frame = space.frame;
  const BitRows roomy =
      component(roomy_cells(space, options.min_gateway_width_m / 2, driven), robot);
  const Frontier frontier(space);
  BitRows lines = slimmed(thinned(roomy));
  Skeleton result{.points = points_of(lines, space)};
  auto exits = exits_at(frontier, lines, result.points, options);
  const BitRows missed = missed_openings(space, frontier, roomy, result.points, exits, options);
  if (missed != BitRows(frame.width, frame.height)) {
    lines = slimmed(thinned(roomy, missed));
    result.points = points_of(lines, space);
    exits = exits_at(frontier, lines, result.points, options);
  }
  for (const std::optional<std::size_t>& exit : exits) {
    if (exit) result.exits.push_back(*exit);
  }
  std::sort(result.exits.begin(), result.exits.end());
  keep_critical(result, frame, options, driven);
  return result;
}

}  // namespace asterism
