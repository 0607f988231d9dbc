#include "metric/free_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>

namespace asterism {
namespace {

// The odds of 0.65 and of 0.196.
constexpr float wall_log_odds = 0.61904F;
constexpr float free_log_odds = -1.41148F;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unknown_cost = 5;  // a detour so many times as long is taken round the unknown
constexpr double beside_cost = 2;   // ... and round cells beside a wall

NotFree sum(const NotFree& a, const NotFree& b) {
  return {a.wall_m + b.wall_m, a.unknown_m + b.unknown_m};
}

// Whether a line runs no more over walls, nor over the unknown, than another; in metres, rounded.
bool is_as_free(const NotFree& a, const NotFree& b) {
  constexpr double rounding_m = 1e-9;
  return a.wall_m <= b.wall_m + rounding_m && a.unknown_m <= b.unknown_m + rounding_m;
}

// A line with points no farther apart than that.
std::vector<Point2> densely(const std::vector<Point2>& line, double apart_m) {
  std::vector<Point2> result{line.front()};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point2 step = line[i] - line[i - 1];
    const double parts = std::max(1.0, std::ceil(norm(step) / apart_m));
    for (double part = 1; part < parts; ++part)
      result.push_back(line[i - 1] + (part / parts) * step);
    result.push_back(line[i]);
  }
  return result;
}

// Ways over a part of a grid that enter no wall but where they start and end, by Dijkstra's
// algorithm.
class Window {
 public:
  Window(const Grid& grid, const std::vector<Point2>& round, double reach_m) : grid_(grid) {
    low_ = high_ = grid.cell_at(round.front());
    for (const Point2 point : round) {
      const Cell cell = grid.cell_at(point);
      low_ = {std::min(low_.column, cell.column), std::min(low_.row, cell.row)};
      high_ = {std::max(high_.column, cell.column), std::max(high_.row, cell.row)};
    }
    const int reach = static_cast<int>(std::ceil(reach_m / grid.resolution_m));
    low_ = {low_.column - reach, low_.row - reach};
    high_ = {high_.column + reach, high_.row + reach};
    width_ = high_.column - low_.column + 1;
  }

  // The middles of the cells between two points; none where there is no way.
  std::vector<Point2> way(Point2 from, Point2 to) const {
    const std::size_t start = index(grid_.cell_at(from));
    const std::size_t goal = index(grid_.cell_at(to));
    const std::size_t cells =
        static_cast<std::size_t>(width_) * static_cast<std::size_t>(high_.row - low_.row + 1);
    std::vector<double> length(cells, infinity);
    std::vector<std::size_t> before(cells);
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    length[start] = 0;
    queue.emplace(0, start);
    while (!queue.empty() && queue.top().second != goal) {
      const auto [so_far, at] = queue.top();
      queue.pop();
      if (so_far > length[at]) continue;
      for_each_step(cell(at), [&](Cell next, double step) {
        const std::size_t there = index(next);
        const double longer = so_far + (there == goal ? step : step * cost(next));
        if (longer >= length[there]) return;
        length[there] = longer;
        before[there] = at;
        queue.emplace(longer, there);
      });
    }
    if (length[goal] == infinity) return {};
    std::vector<Point2> result;
    for (std::size_t at = goal; at != start; at = before[at])
      result.push_back(grid_.centre(cell(at)));
    result.push_back(grid_.centre(cell(start)));
    std::ranges::reverse(result);
    return result;
  }

 private:
  std::size_t index(Cell cell) const {
    return static_cast<std::size_t>(cell.row - low_.row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(cell.column - low_.column);
  }
  Cell cell(std::size_t index) const {
    const auto width = static_cast<std::size_t>(width_);
    return {low_.column + static_cast<int>(index % width),
            low_.row + static_cast<int>(index / width)};
  }
  bool is_wall(Cell cell) const { return ground_at(grid_, cell) == Ground::wall; }

  double cost(Cell cell) const {
    const Ground ground = ground_at(grid_, cell);
    if (ground == Ground::wall) return infinity;
    bool is_beside_wall = false;
    grid_.for_each_round(cell, 1, [&](Cell beside) { is_beside_wall |= is_wall(beside); });
    return (ground == Ground::unknown ? unknown_cost : 1) * (is_beside_wall ? beside_cost : 1);
  }

  // Across a corner only where neither cell beside it is a wall.
  template <class Visit>
  void for_each_step(Cell at, Visit visit) const {
    constexpr std::array<std::pair<int, int>, 8> steps{
        {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
    for (const auto& [right, up] : steps) {
      const Cell next{at.column + right, at.row + up};
      if (next.column < low_.column || next.column > high_.column || next.row < low_.row ||
          next.row > high_.row)
        continue;
      const bool is_across = right != 0 && up != 0;
      if (is_across && (is_wall({at.column + right, at.row}) || is_wall({at.column, at.row + up})))
        continue;
      visit(next, is_across ? std::numbers::sqrt2 : 1);
    }
  }

  const Grid& grid_;
  Cell low_;
  Cell high_;
  int width_ = 0;
};

// Keeps of a line what one of fewer points needs.
class Simplification {
 public:
  Simplification(const Grid& grid, const std::vector<Point2>& line, double tolerance_m)
      : grid_(grid), line_(line), tolerance_m_(tolerance_m), up_to_{{}} {
    for (std::size_t i = 1; i < line.size(); ++i)
      up_to_.push_back(sum(up_to_.back(), not_free(grid, line[i - 1], line[i])));
  }

  std::vector<Point2> result() {
    kept_ = {line_.front()};
    keep_between(0, line_.size() - 1);
    return kept_;
  }

 private:
  double aside_m(std::size_t i, Point2 from, Point2 to) const {
    const Point2 along = to - from;
    const double length_m = norm(along);
    const Point2 away = line_[i] - from;
    if (length_m == 0) return norm(away);
    const double share = std::clamp(dot(away, along) / (length_m * length_m), 0.0, 1.0);
    return norm(away - share * along);
  }

  void keep_between(std::size_t first, std::size_t last) {
    std::size_t farthest = first + (last - first) / 2;
    double off_m = 0;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double aside = aside_m(i, line_[first], line_[last]);
      if (aside > off_m) {
        off_m = aside;
        farthest = i;
      }
    }
    const NotFree before{up_to_[last].wall_m - up_to_[first].wall_m,
                         up_to_[last].unknown_m - up_to_[first].unknown_m};
    if (last - first < 2 ||
        (off_m <= tolerance_m_ && is_as_free(not_free(grid_, line_[first], line_[last]), before))) {
      kept_.push_back(line_[last]);
      return;
    }
    keep_between(first, farthest);
    keep_between(farthest, last);
  }

  const Grid& grid_;
  const std::vector<Point2>& line_;
  double tolerance_m_;
  std::vector<NotFree> up_to_;  ///< [point], of the line before it
  std::vector<Point2> kept_;
};

}  // namespace

Ground ground_at(const Grid& grid, Cell cell) {
  if (!grid.contains(cell)) return Ground::unknown;
  const float log_odds = grid.log_odds[grid.index(cell)];
  if (log_odds > wall_log_odds) return Ground::wall;
  return log_odds < free_log_odds ? Ground::free : Ground::unknown;
}

NotFree not_free(const Grid& grid, Point2 from, Point2 to) {
  const Pose2 grid_from_frame = inverse(grid.frame_from_grid);
  const double cells_per_m = 1 / grid.resolution_m;
  const Point2 start = cells_per_m * (grid_from_frame * from);
  const Point2 step = cells_per_m * (grid_from_frame * to) - start;
  const double length_m = norm(to - from);
  // The share of the line at which it leaves the cells that it crosses, each way.
  struct Axis {
    double next;
    double every;
    int direction;
  };
  const auto axis = [](double at, double along) {
    if (along == 0) return Axis{infinity, infinity, 0};
    const double edge = along > 0 ? std::floor(at) + 1 : std::floor(at);
    return Axis{(edge - at) / along, 1 / std::abs(along), along > 0 ? 1 : -1};
  };
  Axis column = axis(start.x_m, step.x_m);
  Axis row = axis(start.y_m, step.y_m);
  Cell cell{static_cast<int>(std::floor(start.x_m)), static_cast<int>(std::floor(start.y_m))};
  NotFree result;
  for (double share = 0; share < 1;) {
    const double end = std::min({column.next, row.next, 1.0});
    const double part_m = std::max(0.0, end - share) * length_m;
    switch (ground_at(grid, cell)) {
      case Ground::wall:
        result.wall_m += part_m;
        break;
      case Ground::unknown:
        result.unknown_m += part_m;
        break;
      case Ground::free:
        break;
    }
    share = end;
    Axis& crossed = column.next <= row.next ? column : row;
    (&crossed == &column ? cell.column : cell.row) += crossed.direction;
    crossed.next += crossed.every;
  }
  return result;
}

NotFree not_free(const Grid& grid, const std::vector<Point2>& line) {
  NotFree result;
  for (std::size_t i = 1; i < line.size(); ++i)
    result = sum(result, not_free(grid, line[i - 1], line[i]));
  return result;
}

std::vector<Point2> without_loops(const Grid& grid, const std::vector<Point2>& line,
                                  double near_m) {
  std::vector<Point2> result{line.front()};
  for (std::size_t at = 0; at + 1 < line.size();) {
    std::size_t next = line.size() - 1;
    while (next > at + 1 && (norm(line[next] - line[at]) > near_m ||
                             !is_as_free(not_free(grid, line[at], line[next]), {})))
      --next;
    result.push_back(line[next]);
    at = next;
  }
  return result;
}

std::vector<Point2> led_round(const Grid& grid, const std::vector<Point2>& line, double reach_m) {
  const std::vector<Point2> dense = densely(line, grid.resolution_m);
  const auto is_free = [&](std::size_t i) {
    return ground_at(grid, grid.cell_at(dense[i])) == Ground::free;
  };
  const auto is_free_step = [&](std::size_t i) {
    return is_as_free(not_free(grid, dense[i], dense[i + 1]), {});
  };
  std::vector<Point2> result;
  for (std::size_t i = 0; i < dense.size(); ++i) {
    result.push_back(dense[i]);
    if (i + 1 == dense.size() || is_free_step(i)) continue;
    // From here to where the line runs freely again.
    std::size_t end = i + 1;
    while (end + 1 < dense.size() && !(is_free(end) && is_free_step(end))) ++end;
    const auto first = dense.begin() + static_cast<std::ptrdiff_t>(i);
    const std::vector<Point2> part(first, dense.begin() + static_cast<std::ptrdiff_t>(end) + 1);
    std::vector<Point2> round = Window(grid, part, reach_m).way(dense[i], dense[end]);
    if (round.empty()) continue;
    round.insert(round.begin(), dense[i]);
    round.push_back(dense[end]);
    const NotFree before = not_free(grid, part);
    const NotFree after = not_free(grid, round);
    if (after.wall_m < before.wall_m || is_as_free(after, before)) {
      result.insert(result.end(), round.begin() + 1, round.end() - 1);
      i = end - 1;
    }
  }
  return result;
}

std::vector<Point2> simplified(const Grid& grid, const std::vector<Point2>& line,
                               double tolerance_m) {
  return Simplification(grid, line, tolerance_m).result();
}

double least_width_m(const Grid& grid, const std::vector<Point2>& line) {
  constexpr double apart_m = 0.1;
  constexpr double most_m = 10;
  const std::vector<Point2> dense = densely(line, apart_m);
  const auto to_wall_m = [&](Point2 from, Point2 towards) {
    const double step_m = grid.resolution_m / 2;
    double away_m = 0;
    while (away_m < most_m &&
           ground_at(grid, grid.cell_at(from + away_m * towards)) != Ground::wall)
      away_m += step_m;
    return std::min(away_m, most_m);
  };
  double least_m = 2 * most_m;
  for (std::size_t i = 1; i < dense.size(); ++i) {
    if (dense[i] == dense[i - 1]) continue;
    const Point2 left = left_of(unit_towards(dense[i - 1], dense[i]));
    const Point2 middle = 0.5 * (dense[i - 1] + dense[i]);
    least_m = std::min(least_m, to_wall_m(middle, left) + to_wall_m(middle, -1 * left));
  }
  return least_m;
}

}  // namespace asterism
