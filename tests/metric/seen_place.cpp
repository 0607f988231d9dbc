#include "tests/metric/seen_place.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asterism {
namespace {

constexpr float wall_log_odds = 3.5F;
constexpr double wrong_share = 0.005;  // share of the cells

void fill(Grid& grid, Point2 middle, double half_m, float log_odds) {
  const auto [column, row] = grid.cell_at(middle);
  const int half = static_cast<int>(half_m / grid.resolution_m);
  for (Cell cell{0, row - half}; cell.row <= row + half; ++cell.row)
    for (cell.column = column - half; cell.column <= column + half; ++cell.column)
      if (grid.contains(cell)) grid.log_odds[grid.index(cell)] = log_odds;
}

Point2 anywhere(double most_m, RandomEngine& random) {
  return {between(-most_m, most_m, random), between(-most_m, most_m, random)};
}

}  // namespace

Grid seen_from_visit(const IdealWorld& world, const Pose2& world_from_visit) {
  IdealWorld seen = world;
  const Pose2 visit_from_world = inverse(world_from_visit);
  for (IdealCorridor& corridor : seen.corridors) {
    corridor.from = visit_from_world * corridor.from;
    corridor.heading_rad = wrapped(corridor.heading_rad + visit_from_world.heading_rad);
  }
  return drawn(seen);
}

Grid seen_badly(Grid place_map, RandomEngine& random) {
  for (int box = 0; box < 3; ++box) fill(place_map, anywhere(6, random), 0.25, wall_log_odds);
  for (int person = 0; person < 3; ++person)
    fill(place_map, anywhere(4, random), 0.1, wall_log_odds);
  for (int corner = 0; corner < 2; ++corner) fill(place_map, anywhere(8, random), 1.2, 0);
  for (float& log_odds : place_map.log_odds)
    if (chance(wrong_share, random)) log_odds = chance(0.5, random) ? wall_log_odds : -log_odds;
  return place_map;
}

Pose2 any_visit(RandomEngine& random) {
  const Point2 at = anywhere(0.6, random);
  return {at.x_m, at.y_m, between(-std::numbers::pi, std::numbers::pi, random)};
}

Pose2 any_motion(double most_m, double most_rad, RandomEngine& random) {
  const Point2 by = between(0, most_m, random) *
                    unit_vector(between(-std::numbers::pi, std::numbers::pi, random));
  return {by.x_m, by.y_m, between(-most_rad, most_rad, random)};
}

}  // namespace asterism
