#include "perception/pruning.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "perception/shortest_paths.hpp"

namespace asterism {
namespace {

constexpr double entered_m = 1.0;     // so far into a branch the robot has entered it
constexpr double fork_m = 2.0;        // lines fork so far before a dead end
constexpr double least_link_m = 1.0;  // shorter links between two branches are corners of junctions

using Points = std::vector<std::size_t>;

class Pruner {
 public:
  Pruner(Skeleton& skeleton, const Grid& frame, const SkeletonOptions& options)
      : skeleton_(skeleton), frame_(frame), options_(options), all_(skeleton.points.size(), true) {}

  void keep_between_exits() {
    const Points& exits = skeleton_.exits;
    for (std::size_t i = 0; i + 1 < exits.size(); ++i) {
      const ShortestPaths paths = shortest_paths(skeleton_, {exits[i]}, all_);
      for (std::size_t j = i + 1; j < exits.size(); ++j) keep_path(paths, exits[j]);
    }
  }

  // Links off the kept paths that close a long loop, and what joins them to the rest.
  void keep_loops() {
    const std::vector<bool> trunk = without_loose_ends();
    std::vector<bool> seen(skeleton_.points.size(), false);
    for (std::size_t start = 0; start < skeleton_.points.size(); ++start) {
      if (!trunk[start] || !is_fork(start, trunk)) continue;
      for (const std::size_t next : skeleton_.points[start].neighbours) {
        if (!trunk[next] || seen[next] || is_fork(next, trunk)) continue;
        keep_if_long(link(start, next, trunk, seen), trunk);
      }
    }
    // Rings without a fork.
    for (std::size_t start = 0; start < skeleton_.points.size(); ++start) {
      if (!trunk[start] || seen[start] || is_fork(start, trunk)) continue;
      Points line{start};
      for (bool more = true; more;) {
        seen[line.back()] = true;
        more = false;
        for (const std::size_t next : skeleton_.points[line.back()].neighbours) {
          if (more || !trunk[next] || seen[next]) continue;
          line.push_back(next);
          more = true;
        }
      }
      line.push_back(start);
      keep_if_long(line, trunk);
    }
  }

  // Branches that end in a dead end worth a place.
  void keep_dead_ends(std::span<const Point2> driven) {
    std::vector<bool> beyond(skeleton_.points.size(), false);  // the end of a branch that is kept
    for (;;) {
      const Points roots = kept();
      if (roots.empty()) return;
      const ShortestPaths paths = shortest_paths(skeleton_, roots, all_);
      std::optional<std::size_t> deepest;
      for (std::size_t i = 0; i < skeleton_.points.size(); ++i) {
        const double length_m = paths.length[i] * frame_.resolution_m;
        if (!std::isfinite(length_m) || length_m < entered_m) continue;
        if (beyond[i] || (deepest && paths.length[i] <= paths.length[*deepest])) continue;
        const double depth_m = length_m - skeleton_.points[root_of(paths, i)].radius_m;
        if (depth_m < entered_m) continue;
        if (depth_m >= options_.hallway_m || holds_one(i, driven)) deepest = i;
      }
      if (!deepest) return;
      const std::size_t end = widest_before(paths, *deepest);
      keep_path(paths, end);
      skeleton_.dead_ends.push_back(end);
      for (std::size_t at = *deepest; at != end; at = *paths.before[at]) beyond[at] = true;
    }
  }

  // The junction farthest from the one exit, or the farthest point.
  void keep_only_branch() {
    const ShortestPaths paths = shortest_paths(skeleton_, skeleton_.exits, all_);
    std::optional<std::size_t> junction;
    std::size_t farthest = skeleton_.exits.front();
    for (std::size_t i = 0; i < skeleton_.points.size(); ++i) {
      if (!std::isfinite(paths.length[i])) continue;
      if (paths.length[i] > paths.length[farthest]) farthest = i;
      if (skeleton_.points[i].neighbours.size() > 2 &&
          (!junction || paths.length[i] > paths.length[*junction])) {
        junction = i;
      }
    }
    skeleton_.dead_ends.push_back(junction.value_or(farthest));
    keep_path(paths, skeleton_.dead_ends.back());
  }

 private:
  void keep(std::size_t a, std::size_t b) {
    const auto add = [&](std::size_t from, std::size_t to) {
      Neighbours& critical = skeleton_.points[from].critical;
      if (!critical.has(to)) critical.add(to);
    };
    add(a, b);
    add(b, a);
  }

  void keep_path(const ShortestPaths& paths, std::size_t end) {
    for (std::size_t at = end; paths.before[at]; at = *paths.before[at]) {
      keep(at, *paths.before[at]);
    }
  }

  bool is_exit(std::size_t i) const {
    return std::binary_search(skeleton_.exits.begin(), skeleton_.exits.end(), i);
  }

  // What is kept so far; exits count.
  Points kept() const {
    Points result;
    for (std::size_t i = 0; i < skeleton_.points.size(); ++i) {
      if (skeleton_.is_critical(i) || is_exit(i)) result.push_back(i);
    }
    return result;
  }

  std::size_t degree(std::size_t i, const std::vector<bool>& open) const {
    const Neighbours& near = skeleton_.points[i].neighbours;
    return static_cast<std::size_t>(
        std::count_if(near.begin(), near.end(), [&](std::size_t next) { return open[next]; }));
  }

  bool is_fork(std::size_t i, const std::vector<bool>& open) const {
    return skeleton_.is_critical(i) || is_exit(i) || degree(i, open) > 2;
  }

  // The points left when loose ends other than exits are taken away again and again.
  std::vector<bool> without_loose_ends() const {
    std::vector<bool> left = all_;
    Points loose;
    const auto look_at = [&](std::size_t i) {
      if (left[i] && !is_exit(i) && !skeleton_.is_critical(i) && degree(i, left) < 2) {
        left[i] = false;
        loose.push_back(i);
      }
    };
    for (std::size_t i = 0; i < left.size(); ++i) look_at(i);
    while (!loose.empty()) {
      const std::size_t gone = loose.back();
      loose.pop_back();
      for (const std::size_t next : skeleton_.points[gone].neighbours) look_at(next);
    }
    return left;
  }

  // From a fork over `next` to the next fork, both forks included.
  Points link(std::size_t start, std::size_t next, const std::vector<bool>& trunk,
              std::vector<bool>& seen) const {
    Points line{start, next};
    while (!is_fork(line.back(), trunk)) {
      const std::size_t at = line.back();
      const std::size_t before = line[line.size() - 2];
      seen[at] = true;
      for (const std::size_t after : skeleton_.points[at].neighbours) {
        if (trunk[after] && after != before) line.push_back(after);
      }
      if (line.back() == at) break;
    }
    return line;
  }

  void keep_if_long(const Points& line, std::vector<bool> open) {
    double length = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      length += step_length(skeleton_, line[i], line[i + 1]);
    }
    if (length * frame_.resolution_m < least_link_m) return;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) open[line[i]] = false;
    const double back = shortest_paths(skeleton_, {line.front()}, open).length[line.back()];
    const double round_m = (length + back) * frame_.resolution_m;
    if (!std::isfinite(round_m) || round_m < options_.loop_m) return;
    const Points roots = kept();
    if (!roots.empty()) {
      const ShortestPaths joins = shortest_paths(skeleton_, roots, open);
      keep_path(joins, line.front());
      keep_path(joins, line.back());
    }
    for (std::size_t i = 0; i + 1 < line.size(); ++i) keep(line[i], line[i + 1]);
  }

  static std::size_t root_of(const ShortestPaths& paths, std::size_t point) {
    while (paths.before[point]) point = *paths.before[point];
    return point;
  }

  // Lines fork into the corners of a dead end: the widest point shortly before its end.
  std::size_t widest_before(const ShortestPaths& paths, std::size_t end) const {
    std::size_t widest = end;
    const double least = paths.length[end] - fork_m / frame_.resolution_m;
    for (std::size_t at = end; paths.before[at] && paths.length[at] > least;
         at = *paths.before[at]) {
      if (skeleton_.points[at].radius_m > skeleton_.points[widest].radius_m) widest = at;
    }
    return widest;
  }

  bool holds_one(std::size_t i, std::span<const Point2> driven) const {
    const Point2 middle = frame_.centre(skeleton_.points[i].cell);
    const double radius_m = skeleton_.points[i].radius_m;
    return std::any_of(driven.begin(), driven.end(),
                       [&](Point2 point) { return norm(point - middle) <= radius_m; });
  }

  Skeleton& skeleton_;
  const Grid& frame_;
  const SkeletonOptions& options_;
  std::vector<bool> all_;
};

}  // namespace

void keep_critical(Skeleton& skeleton, const Grid& frame, const SkeletonOptions& options,
                   std::span<const Point2> driven) {
  Pruner pruner(skeleton, frame, options);
  pruner.keep_between_exits();
  pruner.keep_loops();
  pruner.keep_dead_ends(driven);
  const bool alone = std::none_of(skeleton.points.begin(), skeleton.points.end(),
                                  [](const SkeletonPoint& p) { return !p.critical.empty(); });
  if (alone && skeleton.exits.size() == 1) pruner.keep_only_branch();
}

}  // namespace asterism
