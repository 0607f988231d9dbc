#include "perception/gateways.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "perception/sight_lines.hpp"

namespace asterism {
namespace {

constexpr int smoothing_points = 3;  // points either side over which r_p is averaged
constexpr double plateau_m_per_m =
    -0.06;                            // change of r_p a metre from which a branch narrows no more
constexpr int axis_search_deg = 40;   // either side of the skeleton's direction
constexpr double axis_range_m = 10;   // how far a gateway looks outwards for its axis
constexpr double chord_weight = 1.0;  // weight of the chord's length against the depth
constexpr double nearly_best = 0.05;  // how much worse a direction still counts
constexpr double short_loop_m = 10;   // a way that comes back to the core sooner leads nowhere
constexpr double border_m = 0.15;     // how far beyond a core's disc its border is looked at

class Finder {
 public:
  Finder(const FreeSpace& space, const Skeleton& skeleton)
      : space_(space), skeleton_(skeleton), sight_lines_(space) {}

  std::optional<Neighbourhood> find(Point2 robot) {
    const std::optional<std::size_t> nearest = nearest_to(robot);
    if (!nearest) return std::nullopt;
    Neighbourhood result;
    find_core(robot, *nearest, result);
    for (const std::size_t f : result.core) mark_disc(f);
    result.unknown_border = unknown_border(result.core);
    leave_core(result.gateways);
    return result;
  }

  std::vector<std::size_t> core(Point2 robot) const {
    const std::optional<std::size_t> nearest = nearest_to(robot);
    if (!nearest) return {};
    Neighbourhood result;
    find_core(robot, *nearest, result);
    std::sort(result.core.begin(), result.core.end());
    return result.core;
  }

 private:
  const SkeletonPoint& point(std::size_t i) const { return skeleton_.points[i]; }
  Point2 at(std::size_t i) const { return space_.frame.centre(point(i).cell); }
  double distance(std::size_t a, std::size_t b) const { return norm(at(a) - at(b)); }

  // c: the critical point closest to the robot.
  std::optional<std::size_t> nearest_to(Point2 robot) const {
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < skeleton_.points.size(); ++i) {
      if (!skeleton_.is_critical(i)) continue;
      if (!nearest || norm(at(i) - robot) < norm(at(*nearest) - robot)) nearest = i;
    }
    return nearest;
  }

  // F: the junctions whose own disc holds the robot, and what neighbours them in turn.
  void find_core(Point2 robot, std::size_t nearest, Neighbourhood& result) const {
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < skeleton_.points.size(); ++i) {
      if (!skeleton_.is_junction(i)) continue;
      (norm(at(i) - robot) <= point(i).radius_m ? result.core : others).push_back(i);
    }
    for (std::size_t next = 0; next < result.core.size(); ++next) {
      const std::size_t own = result.core[next];
      std::erase_if(others, [&](std::size_t other) {
        if (distance(own, other) > std::max(point(own).radius_m, point(other).radius_m)) {
          return false;
        }
        result.core.push_back(other);
        return true;
      });
    }
    if (result.core.empty()) result.core.push_back(nearest);
  }

  void mark_disc(std::size_t f) {
    inside_.resize(skeleton_.points.size(), false);
    for (std::size_t i = 0; i < skeleton_.points.size(); ++i) {
      if (skeleton_.is_critical(i) && distance(f, i) < point(f).radius_m) inside_[i] = true;
    }
    inside_[f] = true;
  }

  double unknown_border(const std::vector<std::size_t>& core) const {
    std::size_t unknown = 0;
    std::size_t all = 0;
    for (const std::size_t f : core) {
      const double radius_m = point(f).radius_m + border_m;
      const int steps = static_cast<int>(2 * std::numbers::pi * radius_m / 0.05);
      for (int step = 0; step < steps; ++step) {
        // What lies behind a wall is unknown for good.
        const Point2 out = unit_vector(2 * std::numbers::pi * step / steps);
        const auto seen = [&](double back_m) {
          return space_.at(sight_lines_.cell_at(at(f) + (radius_m - back_m) * out));
        };
        unknown += seen(0) == Occupancy::unknown && seen(border_m / 2) != Occupancy::occupied &&
                   seen(border_m) != Occupancy::occupied;
        ++all;
      }
    }
    return all == 0 ? 0 : static_cast<double>(unknown) / static_cast<double>(all);
  }

  // Q: from each critical step out of the core's discs, a walk to the first constriction.
  void leave_core(std::vector<Gateway>& gateways) const {
    for (std::size_t i = 0; i < skeleton_.points.size(); ++i) {
      if (!inside_[i]) continue;
      for (const std::size_t next : point(i).critical) {
        if (!inside_[next]) walk(i, next, gateways);
      }
    }
    for (const std::size_t exit : skeleton_.exits) {
      if (inside_[exit]) gateway_at_exit(exit, gateways);
    }
  }

  void walk(std::size_t inside, std::size_t q, std::vector<Gateway>& gateways) const {
    // Some points of the core come along, so that the change of r_p is known at q already.
    std::vector<std::size_t> line = back_from(inside, q);
    const std::size_t first = line.size();
    line.push_back(q);
    for (std::size_t before = inside; line.size() < 400;) {
      const SkeletonPoint& here = point(line.back());
      if (here.critical.size() != 2) break;
      const std::size_t next = here.critical[0] == before ? here.critical[1] : here.critical[0];
      if (inside_[next]) {
        if (static_cast<double>(line.size() - first) * space_.frame.resolution_m < short_loop_m)
          return;
        break;
      }
      before = line.back();
      line.push_back(next);
    }
    const std::size_t m = constriction(line, first);
    gateways.push_back(gateway(line, m));
  }

  std::vector<std::size_t> back_from(std::size_t inside, std::size_t q) const {
    std::vector<std::size_t> line{inside};
    for (std::size_t after = q; line.size() < 2 * smoothing_points + 2;) {
      const SkeletonPoint& here = point(line.back());
      if (here.critical.size() != 2) break;
      const std::size_t next = here.critical[0] == after ? here.critical[1] : here.critical[0];
      after = line.back();
      line.push_back(next);
    }
    std::reverse(line.begin(), line.end());
    return line;
  }

  // The first point from `first` on where r_p, smoothed, stops falling; else where it is least.
  std::size_t constriction(const std::vector<std::size_t>& line, std::size_t first) const {
    const auto size = static_cast<int>(line.size());
    const auto mean = [&](int middle) {
      double sum = 0;
      int count = 0;
      for (int i = std::max(0, middle - smoothing_points);
           i <= std::min(size - 1, middle + smoothing_points); ++i, ++count) {
        sum += point(line[static_cast<std::size_t>(i)]).radius_m;
      }
      return sum / count;
    };
    std::size_t least = first;
    for (int i = static_cast<int>(first); i < size; ++i) {
      const int low = std::max(0, i - smoothing_points);
      const int high = std::min(size - 1, i + smoothing_points);
      const double run_m = (high - low) * space_.frame.resolution_m;
      if (high - low >= 2 * smoothing_points - 1 &&
          (mean(high) - mean(low)) / run_m >= plateau_m_per_m) {
        return static_cast<std::size_t>(i);
      }
      if (point(line[static_cast<std::size_t>(i)]).radius_m < point(line[least]).radius_m) {
        least = static_cast<std::size_t>(i);
      }
    }
    return least;
  }

  Gateway gateway(const std::vector<std::size_t>& line, std::size_t m) const {
    const std::size_t beyond = std::min(line.size() - 1, m + 25);
    const std::size_t before = m >= 5 ? m - 5 : 0;
    const Point2 along = at(line[beyond]) - at(line[before]);
    return with_axis(line[m], norm(along) > 0 ? direction(along) : 0);
  }

  void gateway_at_exit(std::size_t exit, std::vector<Gateway>& gateways) const {
    std::size_t back = exit;
    std::size_t after = exit;
    for (int steps = 0; steps < 10 && !point(back).critical.empty(); ++steps) {
      const auto& next = point(back).critical;
      const std::size_t to = next[0] == after && next.size() > 1 ? next[1] : next[0];
      if (to == after) break;
      after = back;
      back = to;
    }
    const Point2 along = at(exit) - at(back);
    gateways.push_back(with_axis(exit, norm(along) > 0 ? direction(along) : 0));
  }

  // The axis: along it a strip of the gateway's width looks far, and across it the walls are near.
  // Thinned lines run in steps of 45°; walls do not.                            [theory §11, 6]
  Gateway with_axis(std::size_t m, double guess_rad) const {
    const double radius_m = point(m).radius_m;
    std::vector<double> depth;
    std::vector<double> chord;
    for (int step = -axis_search_deg; step <= axis_search_deg; ++step) {
      const Point2 along = unit_vector(guess_rad + radians(step));
      const Point2 left = left_of(along);
      double sum = 0;
      for (int ray = -3; ray <= 3; ++ray) {
        sum += free_length(at(m) + (ray * 0.2 * radius_m) * left, along, axis_range_m);
      }
      depth.push_back(sum);
      chord.push_back(free_length(at(m), left, 2 * radius_m) +
                      free_length(at(m), -1 * left, 2 * radius_m));
    }
    const double deepest = *std::max_element(depth.begin(), depth.end());
    const double shortest = *std::min_element(chord.begin(), chord.end());
    std::vector<double> score;
    for (std::size_t i = 0; i < depth.size(); ++i) {
      score.push_back((deepest > 0 ? depth[i] / deepest : 0) -
                      chord_weight * (shortest > 0 ? chord[i] / shortest - 1 : 0));
    }
    // The middle of the best directions.
    const auto most = std::max_element(score.begin(), score.end());
    const double least = *most - nearly_best;
    double weight = 0;
    double turn = 0;
    for (auto it = most; *it >= least; --it) {
      weight += *it - least;
      turn += (*it - least) * static_cast<double>(it - score.begin());
      if (it == score.begin()) break;
    }
    for (auto it = most + 1; it != score.end() && *it >= least; ++it) {
      weight += *it - least;
      turn += (*it - least) * static_cast<double>(it - score.begin());
    }
    const double degrees = turn / weight - axis_search_deg;
    return {at(m), wrapped(guess_rad + radians(degrees)), 2 * radius_m};
  }

  double free_length(Point2 from, Point2 along, double most_m) const {
    const double step_m = sight_lines_.step_m();
    const int most = static_cast<int>(most_m / step_m) + 1;
    return step_m * sight_lines_.free_steps(from, along, most);
  }

  const FreeSpace& space_;
  const Skeleton& skeleton_;
  SightLines sight_lines_;
  std::vector<bool> inside_{};
};

}  // namespace

std::optional<Neighbourhood> neighbourhood(const FreeSpace& space, const Skeleton& skeleton,
                                           Point2 robot) {
  return Finder(space, skeleton).find(robot);
}

std::vector<std::size_t> core(const FreeSpace& space, const Skeleton& skeleton, Point2 robot) {
  return Finder(space, skeleton).core(robot);
}

}  // namespace asterism
