#include "perception/local_star.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

namespace asterism {
namespace {

Point2 out_of(const Gateway& gateway) { return unit_vector(gateway.outward_rad); }

// How far the inward ray from one gateway's middle passes by the other's segment: the angle by
// which it would have to turn to cross it, 0 if it does.
double misses_by(const Gateway& from, const Gateway& to) {
  const Point2 along = left_of(out_of(to));
  const double inward_rad = from.outward_rad + std::numbers::pi;
  const auto off = [&](double side) {
    return wrapped(direction(to.middle + side * to.width_m / 2 * along - from.middle) - inward_rad);
  };
  const double left_rad = off(-1);
  const double right_rad = off(1);
  if (left_rad * right_rad <= 0 && std::abs(left_rad - right_rad) < std::numbers::pi) return 0;
  return std::min(std::abs(left_rad), std::abs(right_rad));
}

struct Pair {
  double cost = 0;
  std::size_t a = 0;
  std::size_t b = 0;
};

// Of each gateway, the one that continues its path. Best pairs first.
std::vector<std::optional<std::size_t>> continuations(const std::vector<Gateway>& gateways,
                                                      const LocalStarOptions& options) {
  std::vector<Pair> pairs;
  for (std::size_t a = 0; a < gateways.size(); ++a) {
    for (std::size_t b = a + 1; b < gateways.size(); ++b) {
      const double bend_rad =
          std::abs(wrapped(gateways[a].outward_rad - gateways[b].outward_rad - std::numbers::pi));
      if (bend_rad > options.max_bend_rad) continue;
      if (misses_by(gateways[a], gateways[b]) > options.slack_rad) continue;
      if (misses_by(gateways[b], gateways[a]) > options.slack_rad) continue;
      pairs.push_back({bend_rad, a, b});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& p, const Pair& q) { return p.cost < q.cost; });
  std::vector<std::optional<std::size_t>> other(gateways.size());
  for (const Pair& pair : pairs) {
    if (other[pair.a] || other[pair.b]) continue;
    other[pair.a] = pair.b;
    other[pair.b] = pair.a;
  }
  return other;
}

// Where a ray leaves the circle, as an angle from its centre.
double leaves_at(Point2 from, Point2 along, Point2 centre, double radius_m) {
  const Point2 start = from - centre;
  const double half = dot(start, along);
  const double length_m = -half + std::sqrt(half * half + radius_m * radius_m - dot(start, start));
  return direction(start + length_m * along);
}

std::string label(std::size_t number) {
  const char letter = static_cast<char>('a' + number % 26);
  return number < 26 ? std::string(1, letter) : letter + std::to_string(number / 26);
}

}  // namespace

LocalStar local_star(const std::vector<Gateway>& gateways, const LocalStarOptions& options) {
  const auto other = continuations(gateways, options);

  // Rays of an L lie close together near the place; well outside they are in their final order.
  Point2 centre;
  for (const Gateway& gateway : gateways) {
    centre = centre + (1.0 / static_cast<double>(gateways.size())) * gateway.middle;
  }
  double radius_m = 0;
  for (const Gateway& gateway : gateways) {
    radius_m = std::max(radius_m, norm(gateway.middle - centre));
  }
  radius_m = 2 * radius_m + 5;

  struct Ray {
    double clockwise_rad;  // from +x
    std::size_t gateway;
    bool outward;
  };
  std::vector<Ray> rays;
  const auto add = [&](std::size_t gateway, bool outward) {
    const Point2 along = (outward ? 1.0 : -1.0) * out_of(gateways[gateway]);
    const double angle = -leaves_at(gateways[gateway].middle, along, centre, radius_m);
    rays.push_back({angle < 0 ? angle + 2 * std::numbers::pi : angle, gateway, outward});
  };
  for (std::size_t i = 0; i < gateways.size(); ++i) {
    add(i, true);
    if (!other[i]) add(i, false);
  }
  std::stable_sort(rays.begin(), rays.end(),
                   [](const Ray& a, const Ray& b) { return a.clockwise_rad < b.clockwise_rad; });

  std::vector<std::string> labels(gateways.size());
  std::size_t paths = 0;
  std::vector<Arm> arms;
  std::vector<std::size_t> arm_of(gateways.size());
  for (const Ray& ray : rays) {
    const bool first = labels[ray.gateway].empty();
    if (first) {
      labels[ray.gateway] = label(paths++);
      if (other[ray.gateway]) labels[*other[ray.gateway]] = labels[ray.gateway];
    }
    if (ray.outward) arm_of[ray.gateway] = arms.size();
    arms.push_back({labels[ray.gateway], first ? '+' : '-', ray.outward});
  }
  return {Star(std::move(arms)), std::move(arm_of)};
}

bool is_on_path(const LocalStar& local) {
  return local.arm_of_gateway.size() == 2 && local.star.size() == 2;
}

}  // namespace asterism
