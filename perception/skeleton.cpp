#include "perception/skeleton.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <queue>

#include "perception/thinning.hpp"

namespace asterism {
namespace {

constexpr std::array<Cell, 8> kRing{
    {{0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}}};  // clockwise from the
                                                                              // north
constexpr std::array<Cell, 4> kSides{{{0, 1}, {1, 0}, {0, -1}, {-1, 0}}};

Cell operator+(Cell a, Cell b) { return {a.column + b.column, a.row + b.row}; }

int squared_distance(Cell a, Cell b) {
  const int right = a.column - b.column;
  const int up = a.row - b.row;
  return right * right + up * up;
}

// The cells with room for a gateway's half width that are connected to the one nearest the robot.
std::vector<std::uint8_t> roomy_component(const FreeSpace& space, Cell robot, double half_width_m,
                                          std::span<const Point2> driven) {
  const Grid& frame = space.frame;
  std::vector<std::uint8_t> was_there(space.cells.size(), 0);
  for (const Point2 point : driven) {
    const Cell at = frame.cell_at(point);
    if (space.is_free(at)) was_there[frame.index(at)] = 1;
    for (const Cell step : kRing) {
      if (space.is_free(at + step)) was_there[frame.index(at + step)] = 1;
    }
  }
  const auto roomy = [&](Cell cell) {
    return space.clearance(cell) >= half_width_m ||
           (frame.contains(cell) && was_there[frame.index(cell)] != 0);
  };
  std::vector<std::uint8_t> component(space.cells.size(), 0);
  std::optional<Cell> nearest;
  for (int row = 0; row < frame.height; ++row) {
    for (int column = 0; column < frame.width; ++column) {
      const Cell cell{column, row};
      if (!roomy(cell)) continue;
      if (!nearest || squared_distance(cell, robot) < squared_distance(*nearest, robot)) {
        nearest = cell;
      }
    }
  }
  if (!nearest) return component;
  std::vector<Cell> reached{*nearest};
  component[frame.index(*nearest)] = 1;
  for (std::size_t next = 0; next < reached.size(); ++next) {
    for (const Cell side : kSides) {
      const Cell cell = reached[next] + side;
      if (!roomy(cell) || component[frame.index(cell)]) continue;
      component[frame.index(cell)] = 1;
      reached.push_back(cell);
    }
  }
  return component;
}

// Where free space meets the unknown: free cells beside an unknown one, each with the number of the
// 8-connected piece of frontier it belongs to; 0 elsewhere.
std::vector<int> frontiers(const FreeSpace& space) {
  const Grid& frame = space.frame;
  std::vector<int> piece(space.cells.size(), 0);
  std::vector<Cell> front;
  for (int row = 0; row < frame.height; ++row) {
    for (int column = 0; column < frame.width; ++column) {
      const Cell cell{column, row};
      if (!space.is_free(cell)) continue;
      if (std::any_of(kSides.begin(), kSides.end(),
                      [&](Cell side) { return space.at(cell + side) == Occupancy::unknown; })) {
        piece[frame.index(cell)] = -1;
        front.push_back(cell);
      }
    }
  }
  int pieces = 0;
  std::vector<Cell> reached;
  for (const Cell start : front) {
    if (piece[frame.index(start)] != -1) continue;
    piece[frame.index(start)] = ++pieces;
    reached.assign(1, start);
    for (std::size_t next = 0; next < reached.size(); ++next) {
      for (const Cell step : kRing) {
        const Cell cell = reached[next] + step;
        if (!frame.contains(cell) || piece[frame.index(cell)] != -1) continue;
        piece[frame.index(cell)] = pieces;
        reached.push_back(cell);
      }
    }
  }
  return piece;
}

// The opening that an end of the skeleton faces: the longest run of directions in which the first
// cell that is not free is unknown, and near.
struct Opening {
  double width_m = 0;
  int piece = 0;  ///< of frontier
};

Opening opening_at(const FreeSpace& space, const std::vector<int>& pieces, Cell end,
                   double reach_m) {
  constexpr int directions = 120;
  const Grid& frame = space.frame;
  const Point2 from = frame.centre(end);
  const double step_m = frame.resolution_m / 2;
  struct Hit {
    bool unknown = false;
    Point2 at = {};
    int piece = 0;
  };
  std::vector<Hit> hits;
  for (int i = 0; i < directions; ++i) {
    const Point2 along = unit_vector(2 * std::numbers::pi * i / directions);
    Hit hit;
    for (double length_m = 0; length_m <= reach_m; length_m += step_m) {
      const Point2 at = from + length_m * along;
      const Cell cell = frame.cell_at(at);
      if (!space.is_free(cell)) {
        hit.unknown = space.at(cell) == Occupancy::unknown;
        break;
      }
      hit.at = at;
      if (const int piece = pieces[frame.index(cell)]; piece != 0) hit.piece = piece;
    }
    hits.push_back(hit);
  }
  Opening widest;
  for (int start = 0; start < directions; ++start) {
    if (!hits[static_cast<std::size_t>(start)].unknown) continue;
    int last = start;
    while (last + 1 < start + directions &&
           hits[static_cast<std::size_t>((last + 1) % directions)].unknown) {
      ++last;
    }
    double width_m = 0;
    for (int i = start; i < last; ++i) {
      width_m += norm(hits[static_cast<std::size_t>((i + 1) % directions)].at -
                      hits[static_cast<std::size_t>(i % directions)].at);
    }
    const double chord_m = last - start > directions / 3
                               ? width_m
                               : norm(hits[static_cast<std::size_t>(last % directions)].at -
                                      hits[static_cast<std::size_t>(start)].at);
    if (chord_m > widest.width_m) {
      widest = {chord_m, 0};
      for (int i = start; i <= last; ++i) {
        const int piece = hits[static_cast<std::size_t>(i % directions)].piece;
        if (piece != 0) widest.piece = piece;
      }
    }
  }
  return widest;
}

bool is_end(const std::vector<std::uint8_t>& lines, const Grid& frame, Cell cell) {
  const auto on = [&](Cell at) { return frame.contains(at) && lines[frame.index(at)] != 0; };
  int steps = 0;
  int neighbours = 0;
  for (std::size_t i = 0; i < kRing.size(); ++i) {
    const bool here = on(cell + kRing[i]);
    neighbours += here;
    steps += !here && on(cell + kRing[(i + 1) % kRing.size()]);
  }
  return neighbours == 0 || (steps == 1 && neighbours <= 2);
}

// Thinned diagonals may be two cells wide, and paths along them would cross over and back. Takes
// away, one by one, what is not needed to keep the lines 8-connected and is no end.
void slim(std::vector<std::uint8_t>& lines, const Grid& frame) {
  const auto on = [&](Cell at) { return frame.contains(at) && lines[frame.index(at)] != 0; };
  for (int row = 0; row < frame.height; ++row) {
    for (int column = 0; column < frame.width; ++column) {
      const Cell cell{column, row};
      if (!on(cell)) continue;
      int neighbours = 0;
      int pieces = 0;
      for (std::size_t i = 0; i < kRing.size(); ++i) {
        neighbours += on(cell + kRing[i]);
        const bool side = i % 2 == 0;
        pieces += side && !on(cell + kRing[i]) &&
                  (on(cell + kRing[(i + 1) % 8]) || on(cell + kRing[(i + 2) % 8]));
      }
      if (neighbours > 1 && pieces == 1) lines[frame.index(cell)] = 0;
    }
  }
}

void keep(Skeleton& skeleton, std::size_t a, std::size_t b) {
  const auto add = [&](std::size_t from, std::size_t to) {
    auto& kept = skeleton.points[from].critical;
    if (std::find(kept.begin(), kept.end(), to) == kept.end()) kept.push_back(to);
  };
  add(a, b);
  add(b, a);
}

void keep_path(Skeleton& skeleton, const ShortestPaths& paths, std::size_t end) {
  for (std::size_t at = end; paths.before[at]; at = *paths.before[at]) {
    keep(skeleton, at, *paths.before[at]);
  }
}

// With one exit: the junction of the full skeleton farthest from it, or its farthest point.
std::size_t dead_end(const Skeleton& skeleton, const ShortestPaths& paths) {
  std::optional<std::size_t> junction;
  std::size_t farthest = skeleton.exits.front();
  for (std::size_t i = 0; i < skeleton.points.size(); ++i) {
    if (!std::isfinite(paths.length[i])) continue;
    if (paths.length[i] > paths.length[farthest]) farthest = i;
    if (skeleton.points[i].neighbours.size() > 2 &&
        (!junction || paths.length[i] > paths.length[*junction])) {
      junction = i;
    }
  }
  return junction.value_or(farthest);
}

}  // namespace

ShortestPaths shortest_paths(const Skeleton& skeleton, std::size_t start) {
  ShortestPaths paths{.before = std::vector<std::optional<std::size_t>>(skeleton.points.size()),
                      .length = std::vector<double>(skeleton.points.size(),
                                                    std::numeric_limits<double>::infinity())};
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  paths.length[start] = 0;
  open.emplace(0, start);
  while (!open.empty()) {
    const auto [length, at] = open.top();
    open.pop();
    if (length > paths.length[at]) continue;
    for (const std::size_t next : skeleton.points[at].neighbours) {
      const double there = length + std::sqrt(squared_distance(skeleton.points[at].cell,
                                                               skeleton.points[next].cell));
      if (there >= paths.length[next]) continue;
      paths.length[next] = there;
      paths.before[next] = at;
      open.emplace(there, next);
    }
  }
  return paths;
}

Skeleton skeleton(const FreeSpace& space, Cell robot, const SkeletonOptions& options,
                  std::span<const Point2> driven) {
  const Grid& frame = space.frame;
  const double half_width_m = options.min_gateway_width_m / 2;
  std::vector<std::uint8_t> lines =
      thinned(roomy_component(space, robot, half_width_m, driven), frame.width, frame.height);
  slim(lines, frame);

  Skeleton result;
  std::vector<std::size_t> number(lines.size(), 0);
  for (int row = 0; row < frame.height; ++row) {
    for (int column = 0; column < frame.width; ++column) {
      const Cell cell{column, row};
      if (!lines[frame.index(cell)]) continue;
      number[frame.index(cell)] = result.points.size();
      result.points.push_back({.cell = cell, .radius_m = space.clearance(cell)});
    }
  }
  for (SkeletonPoint& point : result.points) {
    for (const Cell step : kRing) {
      const Cell cell = point.cell + step;
      if (frame.contains(cell) && lines[frame.index(cell)]) {
        point.neighbours.push_back(number[frame.index(cell)]);
      }
    }
  }

  // One exit a frontier: where a line forks before it, the end that faces more of it.
  const std::vector<int> pieces = frontiers(space);
  std::map<int, std::pair<double, std::size_t>> exits;  // piece: how much of it is seen, the end
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    const SkeletonPoint& point = result.points[i];
    if (!is_end(lines, frame, point.cell)) continue;
    const Opening opening =
        opening_at(space, pieces, point.cell, 1.5 * point.radius_m + options.exit_reach_m);
    if (opening.width_m < options.exit_share * options.min_gateway_width_m) continue;
    if (opening.piece == 0) continue;  // grazes the unknown between walls
    auto& best = exits[opening.piece];
    best = std::max(best, {opening.width_m, i});
  }
  for (const auto& [piece, exit] : exits) result.exits.push_back(exit.second);
  std::sort(result.exits.begin(), result.exits.end());

  for (std::size_t i = 0; i < result.exits.size(); ++i) {
    const ShortestPaths paths = shortest_paths(result, result.exits[i]);
    for (std::size_t j = i + 1; j < result.exits.size(); ++j) {
      keep_path(result, paths, result.exits[j]);
    }
    if (result.exits.size() == 1) {
      result.dead_end = dead_end(result, paths);
      keep_path(result, paths, *result.dead_end);
    }
  }
  return result;
}

}  // namespace asterism
