#include "metric/place_walls.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace asterism {
namespace {

constexpr float kOccupied = 0.5F;  // log-odds
constexpr float kKnown = 0.3F;
constexpr int kRound = 3;  // cells round one that tell its wall's direction
constexpr double kFewest = 3;
constexpr double kLine = 4;  // times as long as wide is a line
constexpr int kNone = -1;

}  // namespace

PlaceWalls::PlaceWalls(const Grid& place_map, double radius_m)
    : frame_(place_map),
      facing_(unit_vector(place_map.frame_from_grid.heading_rad)),
      known_(place_map.log_odds.size()),
      nearest_(place_map.log_odds.size(), kNone) {
  frame_.log_odds.clear();
  for (std::size_t i = 0; i < known_.size(); ++i)
    known_[i] = std::abs(place_map.log_odds[i]) > kKnown;
  for (Cell cell; cell.row < place_map.height; ++cell.row) {
    for (cell.column = 0; cell.column < place_map.width; ++cell.column) {
      if (place_map.log_odds[place_map.index(cell)] > kOccupied &&
          norm(place_map.centre(cell)) <= radius_m)
        add_piece(place_map, cell);
    }
  }
  std::vector<double> squares_m2(nearest_.size(), std::numeric_limits<double>::infinity());
  for (std::size_t piece = 0; piece < pieces_.size(); ++piece) spread(piece, squares_m2);
}

// The line through the occupied cells round one, at the point nearest to it.
void PlaceWalls::add_piece(const Grid& place_map, Cell cell) {
  double points = 0;
  Point2 sum = {};
  double xx = 0;
  double xy = 0;
  double yy = 0;
  for (int row = std::max(0, cell.row - kRound);
       row <= std::min(place_map.height - 1, cell.row + kRound); ++row) {
    for (int column = std::max(0, cell.column - kRound);
         column <= std::min(place_map.width - 1, cell.column + kRound); ++column) {
      if (place_map.log_odds[place_map.index({column, row})] <= kOccupied) continue;
      const Point2 away{(column - cell.column) * frame_.resolution_m,
                        (row - cell.row) * frame_.resolution_m};
      ++points;
      sum = sum + away;
      xx += away.x_m * away.x_m;
      xy += away.x_m * away.y_m;
      yy += away.y_m * away.y_m;
    }
  }
  if (points < kFewest) return;
  const Point2 mean = (1 / points) * sum;
  xx = xx / points - mean.x_m * mean.x_m;
  xy = xy / points - mean.x_m * mean.y_m;
  yy = yy / points - mean.y_m * mean.y_m;
  const double half = std::hypot((xx - yy) / 2, xy);
  const double cell_spread = frame_.resolution_m * frame_.resolution_m / 12;
  if ((xx + yy) / 2 + half < kLine * ((xx + yy) / 2 - half + cell_spread)) return;
  const Point2 along = unit_vector(0.5 * std::atan2(2 * xy, xx - yy));
  const Point2 across{-along.y_m, along.x_m};
  const Point2 normal = Pose2{0, 0, frame_.frame_from_grid.heading_rad} * across;
  pieces_.push_back({frame_.centre(cell) + dot(mean, across) * normal, normal});
}

Point2 PlaceWalls::in_grid(Point2 in_place) const {
  const Point2 off = in_place - frame_.frame_from_grid.position();
  return {dot(facing_, off), cross(facing_, off)};
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
  if (!cell || nearest_[*cell] == kNone) return nullptr;
  return &pieces_[static_cast<std::size_t>(nearest_[*cell])];
}

bool PlaceWalls::is_known(Point2 in_place) const {
  const auto cell = cell_at(in_place);
  return cell && known_[*cell];
}

}  // namespace asterism
