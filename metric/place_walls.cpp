#include "metric/place_walls.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/plane_covariance.hpp"

namespace asterism {
namespace {

constexpr float wall_log_odds = 0.5F;  // log-odds
constexpr float known_log_odds = 0.3F;
constexpr int round_cells = 3;  // cells round one that tell its wall's direction
constexpr double fewest_points = 3;
constexpr double line_ratio = 4;  // times as long as wide is a line
constexpr int no_piece = -1;

}  // namespace

PlaceWalls::PlaceWalls(const Grid& place_map, double radius_m)
    : frame_(frame_of(place_map)),
      facing_(unit_vector(place_map.frame_from_grid.heading_rad)),
      known_(place_map.log_odds.size()),
      nearest_(place_map.log_odds.size(), no_piece) {
  for (std::size_t i = 0; i < known_.size(); ++i)
    known_[i] = std::abs(place_map.log_odds[i]) > known_log_odds;
  for (Cell cell; cell.row < place_map.height; ++cell.row) {
    for (cell.column = 0; cell.column < place_map.width; ++cell.column) {
      if (place_map.log_odds[place_map.index(cell)] > wall_log_odds &&
          norm(place_map.centre(cell)) <= radius_m)
        add_piece(place_map, cell);
    }
  }
  std::vector<double> squares_m2(nearest_.size(), std::numeric_limits<double>::infinity());
  for (std::size_t piece = 0; piece < pieces_.size(); ++piece) spread(piece, squares_m2);
}

// The line through the occupied cells round one, at the point nearest to it.
void PlaceWalls::add_piece(const Grid& place_map, Cell cell) {
  PointSpread round;
  place_map.for_each_round(cell, round_cells, [&](Cell other) {
    if (place_map.log_odds[place_map.index(other)] <= wall_log_odds) return;
    round.add({(other.column - cell.column) * frame_.resolution_m,
               (other.row - cell.row) * frame_.resolution_m});
  });
  if (round.count() < fewest_points) return;
  const PlaneCovariance spread = round.covariance();
  const double half = spread.half();
  const double cell_spread = frame_.resolution_m * frame_.resolution_m / 12;
  if (spread.middle() + half < line_ratio * (spread.middle() - half + cell_spread)) return;
  const Point2 across = left_of(spread.along());
  const Point2 normal = Pose2{0, 0, frame_.frame_from_grid.heading_rad} * across;
  pieces_.push_back({frame_.centre(cell) + dot(round.mean(), across) * normal, normal});
}

Point2 PlaceWalls::in_grid(Point2 in_place) const {
  return turned_back(facing_, in_place - frame_.frame_from_grid.position());
}

std::optional<std::size_t> PlaceWalls::cell_at(Point2 in_place) const {
  const Point2 point = in_grid(in_place);
  const double column = std::floor(point.x_m / frame_.resolution_m);
  const double row = std::floor(point.y_m / frame_.resolution_m);
  if (!(column >= 0 && column < frame_.width && row >= 0 && row < frame_.height))
    return std::nullopt;
  return frame_.index({static_cast<int>(column), static_cast<int>(row)});
}

void PlaceWalls::spread(std::size_t piece, std::vector<double>& squares_m2) {
  const Point2 point = in_grid(pieces_[piece].point);
  const auto cell_of = [&](double grid_m) {
    return static_cast<int>(std::floor(grid_m / frame_.resolution_m));
  };
  const int last_row = std::min(frame_.height - 1, cell_of(point.y_m + reach_m));
  const int last_column = std::min(frame_.width - 1, cell_of(point.x_m + reach_m));
  for (int row = std::max(0, cell_of(point.y_m - reach_m)); row <= last_row; ++row) {
    const double up_m = (row + 0.5) * frame_.resolution_m - point.y_m;
    for (int column = std::max(0, cell_of(point.x_m - reach_m)); column <= last_column; ++column) {
      const double across_m = (column + 0.5) * frame_.resolution_m - point.x_m;
      const double square_m2 = across_m * across_m + up_m * up_m;
      if (square_m2 > reach_m * reach_m) continue;
      const std::size_t cell = frame_.index({column, row});
      if (square_m2 >= squares_m2[cell]) continue;
      squares_m2[cell] = square_m2;
      nearest_[cell] = static_cast<int>(piece);
    }
  }
}

const WallPiece* PlaceWalls::nearest(Point2 in_place) const {
  const auto cell = cell_at(in_place);
  if (!cell || nearest_[*cell] == no_piece) return nullptr;
  return &pieces_[static_cast<std::size_t>(nearest_[*cell])];
}

bool PlaceWalls::is_known(Point2 in_place) const {
  const auto cell = cell_at(in_place);
  return cell && known_[*cell];
}

}  // namespace asterism
