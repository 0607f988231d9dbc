#include "drawing/fan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drawing/crossings.hpp"

namespace asterism {
namespace {

using Point = MapDrawing::Point;
using Polyline = MapDrawing::Polyline;

constexpr double pi = 3.14159265358979323846;

double bearing(Point from, Point to) { return std::atan2(to.x - from.x, to.y - from.y); }

double distance(Point p, Point a, Point b) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const double along = ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / (length * length);
  const double share = std::clamp(along, 0.0, 1.0);
  return std::hypot(a.x + share * (b.x - a.x) - p.x, a.y + share * (b.y - a.y) - p.y);
}

/// How near the knees and ends of lines come to other lines.
double clearance(const std::vector<Polyline>& lines) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Polyline& line : lines)
    for (const Polyline& other : lines)
      for (std::size_t i = 1; &other != &line && i < line.size(); ++i)
        for (std::size_t j = 1; j < other.size(); ++j)
          nearest = std::min(nearest, distance(line[i], other[j - 1], other[j]));
  return nearest;
}

}  // namespace

std::vector<Polyline> fan(Point centre, const std::vector<Point>& rim, double radius) {
  const double step = 2 * pi / static_cast<double>(rim.size());
  // The first arm's even direction: least squares of the turns from even to straight.
  double sine = 0, cosine = 0;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const double turn = bearing(centre, rim[i]) - step * static_cast<double>(i);
    sine += std::sin(turn);
    cosine += std::cos(turn);
  }
  const double first = std::atan2(sine, cosine);

  const auto lines = [&](double straightness) {
    std::vector<Polyline> result;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const double even = first + step * static_cast<double>(i);
      const double to_straight = std::remainder(bearing(centre, rim[i]) - even, 2 * pi);
      const double direction = even + straightness * to_straight;
      result.push_back(
          {centre,
           {centre.x + radius * std::sin(direction), centre.y + radius * std::cos(direction)},
           rim[i]});
    }
    return result;
  };
  const auto room = [&](const std::vector<Polyline>& some) {
    return std::min(clearance(some), radius / 2);
  };

  std::vector<Polyline> best = lines(1);
  for (const double straightness : {0.8, 0.6, 0.4, 0.2, 0.0})
    if (const auto evener = lines(straightness);
        meet_only_at_start(evener) && room(evener) >= room(best))
      best = evener;
  return best;
}

}  // namespace asterism
