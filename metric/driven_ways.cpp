#include "metric/driven_ways.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>
#include <vector>

#include "metric/free_line.hpp"

namespace asterism {
namespace {

constexpr double tolerance_m = 0.05;
constexpr double near_m = 0.1;     // one comes by a spot again
constexpr double reach_m = 2;      // of the way round a wall
constexpr double smooth_m = 0.25;  // turns over less than this are noise

using Line = std::vector<Point2>;

double length_m(const Line& line) {
  double sum_m = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum_m += norm(line[i] - line[i - 1]);
  return sum_m;
}

double turned_rad(const Grid& grid, const Line& line) {
  const Line smooth = simplified(grid, line, smooth_m);
  double sum_rad = 0;
  for (std::size_t i = 2; i < smooth.size(); ++i) {
    const Point2 before = smooth[i - 1] - smooth[i - 2];
    const Point2 after = smooth[i] - smooth[i - 1];
    sum_rad += std::abs(std::atan2(cross(before, after), dot(before, after)));
  }
  return sum_rad;
}

class Ways {
 public:
  Ways(const Trace& trace, const TopologicalMap& map, const Trajectory& trajectory,
       const Grid& global_map)
      : trace_(trace), map_(map), trajectory_(trajectory), grid_(global_map) {
    for (const TopologicalMap::Place& place : map.places)
      layout_from_place_.push_back(
          trajectory[scans(place.first_visit.index())[0]].layout_from_robot);
  }

  DrivenWays result() const {
    std::map<TopologicalMap::Segment, Line> best;
    for (std::size_t k = 0; k + 1 < map_.visits.size(); ++k) {
      if (!map_.left[k]) continue;  // where a trace is cut, no segment was driven
      const PlaceArm out{map_.visits[k], *map_.left[k]};
      const PlaceArm in{map_.visits[k + 1], map_.entered[k + 1].value()};
      Line line = driven(k);
      if (in < out) std::ranges::reverse(line);
      const TopologicalMap::Segment segment{std::min(out, in), std::max(out, in)};
      const auto [found, is_new] = best.try_emplace(segment, line);
      if (!is_new && is_better(line, found->second)) found->second = line;
    }
    DrivenWays ways{layout_from_place_};
    for (const TopologicalMap::Segment& segment : map_.segments) {
      Line& line = best.at(segment);
      ways.of_segment.push_back({line, length_m(line), least_width_m(grid_, line)});
    }
    return ways;
  }

 private:
  std::array<std::size_t, 2> scans(std::size_t visit) const {
    const auto [first, last] = trace_.visits[visit].scans.value();
    return {static_cast<std::size_t>(first), static_cast<std::size_t>(last)};
  }
  Point2 at(std::size_t scan) const { return trajectory_[scan].layout_from_robot.position(); }

  // From the place of a visit to that of the next: leaves the one and comes to the other where the
  // robot is nearest to where ways meet there.
  Line driven(std::size_t k) const {
    const Point2 from = layout_from_place_[map_.visits[k].index()].position();
    const Point2 to = layout_from_place_[map_.visits[k + 1].index()].position();
    const auto nearest = [&](std::size_t visit, Point2 place) {
      const auto [first, last] = scans(visit);
      std::size_t best = first;
      for (std::size_t scan = first; scan <= last; ++scan)
        if (norm(at(scan) - place) < norm(at(best) - place)) best = scan;
      return best;
    };
    Line line{from};
    const std::size_t last = nearest(k + 1, to);
    for (std::size_t scan = nearest(k, from); scan <= last; ++scan) line.push_back(at(scan));
    line.push_back(to);
    const Line short_line = without_loops(grid_, line, near_m);
    return simplified(grid_, led_round(grid_, short_line, reach_m), tolerance_m);
  }

  bool is_better(const Line& a, const Line& b) const {
    const auto faults = [&](const Line& line) {
      // In millimetres: what is less is noise.
      const NotFree found = not_free(grid_, line);
      return std::tuple(std::lround(1e3 * found.wall_m), std::lround(1e3 * found.unknown_m),
                        turned_rad(grid_, line));
    };
    return faults(a) < faults(b);
  }

  const Trace& trace_;
  const TopologicalMap& map_;
  const Trajectory& trajectory_;
  const Grid& grid_;
  std::vector<Pose2> layout_from_place_;
};

}  // namespace

DrivenWays driven_ways(const Trace& trace, const TopologicalMap& map, const Trajectory& trajectory,
                       const Grid& global_map) {
  return Ways(trace, map, trajectory, global_map).result();
}

}  // namespace asterism
