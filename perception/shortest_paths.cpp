#include "perception/shortest_paths.hpp"

#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>

namespace asterism {

double step_length(const Skeleton& skeleton, std::size_t a, std::size_t b) {
  const Cell from = skeleton.points[a].cell;
  const Cell to = skeleton.points[b].cell;
  return from.column == to.column || from.row == to.row ? 1 : std::numbers::sqrt2;
}

ShortestPaths shortest_paths(const Skeleton& skeleton, const std::vector<std::size_t>& starts,
                             const std::vector<bool>& open) {
  ShortestPaths paths{.before = std::vector<std::optional<std::size_t>>(skeleton.points.size()),
                      .length = std::vector<double>(skeleton.points.size(),
                                                    std::numeric_limits<double>::infinity())};
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const std::size_t start : starts) {
    paths.length[start] = 0;
    queue.emplace(0, start);
  }
  while (!queue.empty()) {
    const auto [length, at] = queue.top();
    queue.pop();
    if (length > paths.length[at]) continue;
    for (const std::size_t next : skeleton.points[at].neighbours) {
      const double there = length + step_length(skeleton, at, next);
      if (!open[next] || there >= paths.length[next]) continue;
      paths.length[next] = there;
      paths.before[next] = at;
      queue.emplace(there, next);
    }
  }
  return paths;
}

}  // namespace asterism
