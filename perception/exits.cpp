#include "perception/exits.hpp"

#include <algorithm>
#include <cmath>

#include "perception/cells.hpp"

namespace asterism {
namespace {

constexpr double near_radii = 1.25;  // radii from which, with the reach, a point is near an opening

double reach_m(double radius_m, const SkeletonOptions& options) {
  return 1.5 * radius_m + options.exit_reach_m;
}

double least_width_m(const SkeletonOptions& options) {
  return options.exit_share * options.min_gateway_width_m;
}

// A piece of frontier: how many cells, and the one nearest their mean.
struct Extent {
  int cells = 0;
  Cell middle = {};
};

std::vector<Extent> extents(const Pieces& frontier) {
  struct Sum {
    double columns = 0;
    double rows = 0;
  };
  std::vector<Extent> extents(frontier.count());
  std::vector<Sum> sums(frontier.count());
  for (const Pieces::Run& run : frontier.runs()) {
    const int cells = run.past - run.first;
    extents[run.piece] = {extents[run.piece].cells + cells, {run.first, run.row}};
    sums[run.piece].columns += cells * (run.first + run.past - 1) / 2.0;
    sums[run.piece].rows += cells * run.row;
  }
  for (const Pieces::Run& run : frontier.runs()) {
    auto& [cells, middle] = extents[run.piece];
    const Cell mean{static_cast<int>(std::lround(sums[run.piece].columns / cells)),
                    static_cast<int>(std::lround(sums[run.piece].rows / cells))};
    const Cell cell{std::clamp(mean.column, run.first, run.past - 1), run.row};
    if (squared_distance(cell, mean) < squared_distance(middle, mean)) middle = cell;
  }
  return extents;
}

// The set cell nearest `to`, at most `reach` rows and columns away.
std::optional<Cell> nearest_cell(const BitRows& picture, Cell to, int reach) {
  std::optional<Cell> nearest;
  for (int up = -reach; up <= reach; ++up) {
    for (int right = -reach; right <= reach; ++right) {
      const Cell cell = to + Cell{right, up};
      if (!picture.has(cell)) continue;
      if (!nearest || squared_distance(cell, to) < squared_distance(*nearest, to)) nearest = cell;
    }
  }
  return nearest;
}

}  // namespace

bool is_end(const BitRows& lines, Cell cell) {
  int steps = 0;
  int neighbours = 0;
  for (std::size_t i = 0; i < ring_steps.size(); ++i) {
    const bool here = lines.has(cell + ring_steps[i]);
    neighbours += here;
    steps += !here && lines.has(cell + ring_steps[(i + 1) % ring_steps.size()]);
  }
  return neighbours == 0 || (steps == 1 && neighbours <= 2);
}

std::vector<std::optional<std::size_t>> exits_at(const Frontier& frontier, const BitRows& lines,
                                                 const std::vector<SkeletonPoint>& points,
                                                 const SkeletonOptions& options) {
  std::vector<std::optional<std::size_t>> exits(frontier.pieces().count());
  std::vector<double> widest_m(exits.size(), least_width_m(options));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_end(lines, points[i].cell)) continue;
    const Frontier::Opening opening =
        frontier.opening_at(points[i].cell, reach_m(points[i].radius_m, options));
    if (!opening.piece || opening.width_m < widest_m[*opening.piece]) continue;
    widest_m[*opening.piece] = opening.width_m;
    exits[*opening.piece] = i;
  }
  return exits;
}

BitRows missed_openings(const FreeSpace& space, const Frontier& frontier, const BitRows& roomy,
                        const std::vector<SkeletonPoint>& points,
                        const std::vector<std::optional<std::size_t>>& exits,
                        const SkeletonOptions& options) {
  const Grid& frame = space.frame;
  const SightLines sight_lines(space);
  // What was thinned ends half a gateway's width before the frontier.
  const int gap = static_cast<int>(options.min_gateway_width_m / 2 / frame.resolution_m) + 2;
  const auto is_near = [&](const SkeletonPoint& point, Cell middle) {
    const double far_m = std::sqrt(squared_distance(point.cell, middle)) * frame.resolution_m;
    if (far_m > near_radii * point.radius_m + options.exit_reach_m) return false;
    const Point2 from = frame.centre(point.cell);
    const int steps = static_cast<int>(far_m / sight_lines.step_m());
    return steps == 0 ||
           sight_lines.free_steps(from, 1 / far_m * (frame.centre(middle) - from), steps) == steps;
  };
  BitRows missed(frame.width, frame.height);
  const std::vector<Extent> all = extents(frontier.pieces());
  for (std::size_t piece = 0; piece < all.size(); ++piece) {
    const auto [cells, middle] = all[piece];
    if (exits[piece] || 1.5 * cells * frame.resolution_m < least_width_m(options)) continue;
    const std::optional<Cell> end = nearest_cell(roomy, middle, gap);
    if (!end || std::any_of(points.begin(), points.end(), [&, middle = middle](const auto& point) {
          return is_near(point, middle);
        })) {
      continue;
    }
    const Frontier::Opening opening =
        frontier.opening_at(*end, reach_m(space.clearance(*end), options));
    if (opening.piece == piece && opening.width_m >= least_width_m(options)) missed.set(*end);
  }
  return missed;
}

}  // namespace asterism
