#include "simulation/grid_world.hpp"

#include <vector>

#include "simulation/drawn_world.hpp"

namespace asterism {
namespace {

/// Cuts one line of the grid into corridors where neighbours are not joined.
///
/// @param line  the points, in order along +
void add_corridors(const Corridor& line, const GridOptions& options, RandomEngine& engine,
                   std::vector<Corridor>& corridors) {
  Corridor corridor{line.label, line.direction, {}};
  const auto finish = [&](bool is_last) {
    const bool is_first = corridor.points.front() == line.points.front();
    corridor.stub_at_start = !is_first && chance(options.stubs, engine);
    corridor.stub_at_end = !is_last && chance(options.stubs, engine);
    const bool has_gateway =
        corridor.points.size() > 1 || corridor.stub_at_start || corridor.stub_at_end;
    if (has_gateway) corridors.push_back(corridor);
    corridor.points.clear();
  };
  for (const std::size_t point : line.points) {
    corridor.points.push_back(point);
    const bool is_last = point == line.points.back();
    if (is_last || chance(options.missing, engine)) finish(is_last);
  }
}

World draw(const GridOptions& options, RandomEngine& engine) {
  const auto [width, height] = std::pair(options.width, options.height);
  std::vector<Point2> points;
  for (std::size_t row = 0; row < height; ++row)
    for (std::size_t column = 0; column < width; ++column)
      points.push_back({options.pitch_m * static_cast<double>(column),
                        -options.pitch_m * static_cast<double>(row)});
  std::vector<Corridor> corridors;
  for (std::size_t row = 0; row < height; ++row) {
    Corridor line{"h", {1, 0}, {}};
    for (std::size_t column = 0; column < width; ++column)
      line.points.push_back(row * width + column);
    add_corridors(line, options, engine, corridors);
  }
  for (std::size_t column = 0; column < width; ++column) {
    Corridor line{"v", {0, 1}, {}};
    for (std::size_t row = height; row-- > 0;) line.points.push_back(row * width + column);
    add_corridors(line, options, engine, corridors);
  }
  return make_world(points, corridors);
}

}  // namespace

World grid_world(const GridOptions& options, RandomEngine& engine) {
  return drawn_world(
      options.min_places, [&] { return draw(options, engine); }, "grid",
      "a larger grid or fewer missing corridors");
}

}  // namespace asterism
