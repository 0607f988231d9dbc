#include "tests/support/ideal_world.hpp"

#include <cmath>
#include <numbers>

namespace asterism {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double wall_m = 0.3;
constexpr float free_log_odds = -3.5F;
constexpr float wall_log_odds = 3.5F;

// At which side of the walls a point lies.
enum class Side { inside, wall, outside };

Side side_of(const IdealCorridor& corridor, Point2 point) {
  const Point2 along = unit_vector(corridor.heading_rad);
  const double ahead_m = dot(point - corridor.from, along);
  const double aside_m = std::abs(cross(along, point - corridor.from));
  // The far end is open: nothing was seen beyond.
  if (ahead_m > corridor.length_m) return Side::outside;
  if (ahead_m >= -corridor.back_m && aside_m <= corridor.width_m / 2) return Side::inside;
  const bool near =
      ahead_m >= -corridor.back_m - wall_m && aside_m <= corridor.width_m / 2 + wall_m;
  return near ? Side::wall : Side::outside;
}

Side side_of(const IdealWorld& world, Point2 point) {
  Side side = Side::outside;
  if (world.hall_m > 0) {
    if (norm(point) <= world.hall_m) return Side::inside;
    if (norm(point) <= world.hall_m + wall_m) side = Side::wall;
  }
  for (const IdealCorridor& corridor : world.corridors) {
    const Side own = side_of(corridor, point);
    if (own == Side::inside) return own;
    if (own == Side::wall) side = own;
  }
  return side;
}

}  // namespace

std::vector<IdealWorld> ideal_worlds(double width_m) {
  const auto star = [width_m](std::string name, std::string text,
                              const std::vector<double>& degrees) {
    IdealWorld world{.name = std::move(name), .star = std::move(text)};
    for (const double heading : degrees) {
      world.corridors.push_back(
          {.heading_rad = heading * pi / 180, .width_m = width_m, .back_m = width_m / 2});
    }
    return world;
  };
  std::vector<IdealWorld> worlds{
      star("L", "a+1 b+1 a-0 b-0", {0, 90}),
      star("T", "a+1 b+1 a-1 b-0", {0, 90, 180}),
      star("+", "a+1 b+1 a-1 b-1", {0, 90, 180, 270}),
      star("Y", "a+1 b+0 c+1 a-0 b-1 c-0", {0, 120, 240}),
      star("dead end", "a+1 a-0", {0}),
      star("hall", "a+1 b+1 a-1 b-1", {0, 90, 180, 270}),
      star("corridor", "a+1 a-1", {0, 180}),
  };
  worlds[5].hall_m = 1.5 * width_m;
  return worlds;
}

Point2 turned(Point2 point, double angle_rad) { return Pose2{0, 0, angle_rad} * point; }

IdealWorld turned(IdealWorld world, double angle_rad) {
  for (IdealCorridor& corridor : world.corridors) {
    corridor.from = turned(corridor.from, angle_rad);
    corridor.heading_rad = wrapped(corridor.heading_rad + angle_rad);
  }
  return world;
}

IdealWorld mirrored(IdealWorld world) {
  for (IdealCorridor& corridor : world.corridors) {
    corridor.from.y_m = -corridor.from.y_m;
    corridor.heading_rad = wrapped(-corridor.heading_rad);
  }
  return world;
}

Grid drawn(const IdealWorld& world, int cells, double resolution_m) {
  const double half_m = cells * resolution_m / 2;
  Grid grid{.width = cells,
            .height = cells,
            .resolution_m = resolution_m,
            .frame_from_grid = {-half_m, -half_m, 0}};
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      const Side side = side_of(world, grid.centre({column, row}));
      grid.log_odds.push_back(side == Side::inside ? free_log_odds
                              : side == Side::wall ? wall_log_odds
                                                   : 0.0F);
    }
  }
  return grid;
}

}  // namespace asterism
