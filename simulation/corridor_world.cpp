#include "simulation/corridor_world.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "simulation/drawn_world.hpp"

namespace asterism {
namespace {

/// Crossings this flat would be hard to tell from a corridor that goes on.
constexpr double min_sine_of_crossing = 0.35;

/// Without std::hypot, which differs between machines.
double length(Point2 a) { return std::sqrt(dot(a, a)); }

/// A corridor's middle line.
struct Line {
  Point2 start;
  Point2 direction;  ///< unit
  double length_m = 0;
  std::vector<std::pair<double, std::size_t>> points = {};  ///< distance from start [m], point
};

/// Uniform over directions, without the trigonometry that differs between machines.
Point2 random_direction(RandomEngine& engine) {
  while (true) {
    const Point2 point{between(-1, 1, engine), between(-1, 1, engine)};
    const double radius = length(point);
    if (radius > 0.1 && radius <= 1) return (1 / radius) * point;
  }
}

Line random_line(const CorridorOptions& options, RandomEngine& engine) {
  const double x_m = between(0, options.side_m, engine);
  const double y_m = between(0, options.side_m, engine);
  const Point2 direction = random_direction(engine);
  const double length_m = between(options.min_length_m, options.max_length_m, engine);
  return {Point2{x_m, y_m} - (length_m / 2) * direction, direction, length_m};
}

double distance_m(Point2 point, const Line& line) {
  const double along_m = std::clamp(dot(point - line.start, line.direction), 0.0, line.length_m);
  return length(point - line.start - along_m * line.direction);
}

/// How far along `line` it crosses `other`, if it does.
std::optional<double> crossing_m(const Line& line, const Line& other) {
  const double sine = cross(line.direction, other.direction);
  if (sine == 0) return std::nullopt;
  const Point2 offset = other.start - line.start;
  const double along_m = cross(offset, other.direction) / sine;
  const double along_other_m = cross(offset, line.direction) / sine;
  const bool is_on_both = along_m >= 0 && along_m <= line.length_m && along_other_m >= 0 &&
                          along_other_m <= other.length_m;
  return is_on_both ? std::optional(along_m) : std::nullopt;
}

bool ends_are_clear(const Line& line, const Line& other, double clearance_m) {
  return distance_m(line.start, other) >= clearance_m &&
         distance_m(line.start + line.length_m * line.direction, other) >= clearance_m;
}

/// Whether `line` keeps its distance from the others and from every crossing.
bool has_room(const Line& line, const std::vector<Line>& others,
              const std::vector<Point2>& crossings, double clearance_m) {
  std::vector<Point2> all = crossings;
  for (const Line& other : others) {
    if (!ends_are_clear(line, other, clearance_m) || !ends_are_clear(other, line, clearance_m))
      return false;
    const auto along_m = crossing_m(line, other);
    if (!along_m) continue;
    if (std::abs(cross(line.direction, other.direction)) < min_sine_of_crossing) return false;
    const Point2 crossing = line.start + *along_m * line.direction;
    for (const Point2& point : all)
      if (length(crossing - point) < clearance_m) return false;
    all.push_back(crossing);
  }
  return true;
}

enum class End { crossing, blind, dead };

End random_end(const CorridorOptions& options, RandomEngine& engine) {
  const double draw = uniform(engine);
  if (draw < options.ends_crossing) return End::crossing;
  return draw < options.ends_crossing + options.ends_blind ? End::blind : End::dead;
}

/// Gives a line that crosses others its two ends.
Corridor finish(Line line, std::size_t number, const CorridorOptions& options,
                std::vector<Point2>& points, RandomEngine& engine) {
  std::sort(line.points.begin(), line.points.end());
  Corridor corridor{std::string("c").append(std::to_string(number)), line.direction, {}};
  for (const auto& [along_m, point] : line.points) corridor.points.push_back(point);
  End first = random_end(options, engine);
  const End last = random_end(options, engine);
  const bool would_vanish =
      line.points.size() == 1 && first == End::crossing && last == End::crossing;
  if (would_vanish) first = End::dead;
  corridor.stub_at_start = first == End::blind;
  corridor.stub_at_end = last == End::blind;
  if (first == End::dead) {
    corridor.points.insert(corridor.points.begin(), points.size());
    points.push_back(line.start);
  }
  if (last == End::dead) {
    corridor.points.push_back(points.size());
    points.push_back(line.start + line.length_m * line.direction);
  }
  return corridor;
}

World draw(const CorridorOptions& options, RandomEngine& engine) {
  constexpr int tries = 50;
  std::vector<Line> lines;
  std::vector<Point2> points;
  for (std::size_t i = 0; i < options.corridors; ++i) {
    Line line = random_line(options, engine);
    for (int n = 1; n < tries && !has_room(line, lines, points, options.clearance_m); ++n)
      line = random_line(options, engine);
    if (!has_room(line, lines, points, options.clearance_m)) continue;
    for (Line& other : lines) {
      const auto along_m = crossing_m(line, other);
      if (!along_m) continue;
      const Point2 crossing = line.start + *along_m * line.direction;
      line.points.emplace_back(*along_m, points.size());
      other.points.emplace_back(length(crossing - other.start), points.size());
      points.push_back(crossing);
    }
    lines.push_back(std::move(line));
  }
  std::vector<Corridor> corridors;
  for (const Line& line : lines)
    if (!line.points.empty())
      corridors.push_back(finish(line, corridors.size(), options, points, engine));
  return make_world(points, corridors);
}

}  // namespace

World corridor_world(const CorridorOptions& options, RandomEngine& engine) {
  return drawn_world(
      options.min_places, [&] { return draw(options, engine); }, "world",
      "more or longer corridors");
}

}  // namespace asterism
