#include "tests/drawing/drawing_check.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace asterism {
namespace {

using Point = MapDrawing::Point;
using Polyline = MapDrawing::Polyline;

constexpr double trimmed = 0.1;     ///< shorter than any piece of a drawing
constexpr double clearance = 1e-3;  ///< far above rounding, far below the distance of two arms

double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }
Point between(Point a, Point b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

double distance(Point p, Point a, Point b) {
  const double along = (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y);
  const double squared = distance(a, b) * distance(a, b);
  return distance(p, between(a, b, std::clamp(along / squared, 0.0, 1.0)));
}

/// Of two straight pieces: 0 if the parameters of their intersection lie within both.
double distance(Point a, Point b, Point c, Point d) {
  const double cross = (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x);
  if (cross != 0) {
    const double s = ((c.x - a.x) * (d.y - c.y) - (c.y - a.y) * (d.x - c.x)) / cross;
    const double t = ((c.x - a.x) * (b.y - a.y) - (c.y - a.y) * (b.x - a.x)) / cross;
    if (0 <= s && s <= 1 && 0 <= t && t <= 1) return 0;
  }
  return std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
}

/// The lines of a drawing without the pieces next to places, which meet there by right.
std::map<std::string, Polyline> trimmed_lines(const TopologicalMap& map,
                                              const MapDrawing& drawing) {
  std::map<std::string, Polyline> lines;
  const auto trim = [](Point end, Point next) {
    return between(end, next, trimmed / distance(end, next));
  };
  std::map<PlaceArm, bool> is_joined;
  for (std::size_t s = 0; s < map.segments.size(); ++s) {
    Polyline line = drawing.segments[s];
    const Point last = trim(line.back(), line[line.size() - 2]);
    line.front() = trim(line[0], line[1]);
    line.back() = last;
    lines["segment " + std::to_string(s)] = line;
    is_joined[map.segments[s].first] = is_joined[map.segments[s].second] = true;
  }
  for (std::size_t p = 0; p < map.places.size(); ++p)
    for (std::size_t arm = 0; arm < map.places[p].star.size(); ++arm)
      if (!is_joined[{PlaceId(p), arm}])
        lines["arm " + std::to_string(arm) + " of place " + std::to_string(p)] = {
            trim(drawing.places[p], drawing.arms[p][arm]), drawing.arms[p][arm]};
  return lines;
}

}  // namespace

std::string fault_of_crossings(const TopologicalMap& map, const MapDrawing& drawing) {
  const auto lines = trimmed_lines(map, drawing);
  for (const auto& [name, line] : lines) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      for (const Point& place : drawing.places)
        if (distance(place, line[i - 1], line[i]) < trimmed / 2) return name + " meets a place";
      for (const auto& [other_name, other] : lines) {
        const bool is_same = &other == &line;
        for (std::size_t j = 1; j < other.size(); ++j)
          if ((!is_same || j > i + 1) &&
              distance(line[i - 1], line[i], other[j - 1], other[j]) < clearance)
            return name + " meets " + other_name;
      }
    }
  }
  return "";
}

std::string fault_of_stars(const TopologicalMap& map, const MapDrawing& drawing) {
  std::vector<std::vector<Point>> aims = drawing.arms;  // where each arm's line goes first
  for (std::size_t s = 0; s < map.segments.size(); ++s) {
    const auto& [one, other] = map.segments[s];
    const Polyline& line = drawing.segments[s];
    if (distance(line.front(), drawing.places[one.place.index()]) > 0 ||
        distance(line.back(), drawing.places[other.place.index()]) > 0)
      return "segment " + std::to_string(s) + " does not join its places";
    aims[one.place.index()][one.arm] = line[1];
    aims[other.place.index()][other.arm] = line[line.size() - 2];
  }
  for (std::size_t p = 0; p < map.places.size(); ++p) {
    for (std::size_t q = 0; q < p; ++q)
      if (distance(drawing.places[p], drawing.places[q]) < 2 * trimmed)
        return "places " + std::to_string(q) + " and " + std::to_string(p) + " coincide";
    const auto bearing = [&](Point aim) {
      return std::atan2(aim.x - drawing.places[p].x, aim.y - drawing.places[p].y);
    };
    double circle = 0;
    for (std::size_t arm = 0; arm < aims[p].size(); ++arm) {
      const Point aim = aims[p][arm];
      if (std::abs(std::remainder(bearing(aim) - bearing(drawing.arms[p][arm]), 2 * M_PI)) > 1e-9)
        return "place " + std::to_string(p) + " points an arm elsewhere than its segment goes";
      const double step = bearing(aims[p][(arm + 1) % aims[p].size()]) - bearing(aim);
      circle += step <= 0 ? step + 2 * M_PI : step;
    }
    if (std::abs(circle - 2 * M_PI) > 1e-6)
      return "place " + std::to_string(p) + " has its arms out of order";
  }
  return "";
}

}  // namespace asterism
