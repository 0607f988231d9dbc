#include "metric/place_walls.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

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
  for (std::size_t piece = 0; piece < pieces_.size(); ++piece) spread(piece);
}

// The line through the occupied cells round one, at the point nearest to it.
void PlaceWalls::add_piece(const Grid& place_map, Cell cell) {
  const Point2 here = place_map.centre(cell);
  double points = 0;
  Point2 sum = {};
  double xx = 0;
  double xy = 0;
  double yy = 0;
  for (int row = cell.row - kRound; row <= cell.row + kRound; ++row) {
    for (int column = cell.column - kRound; column <= cell.column + kRound; ++column) {
      const Cell other{column, row};
      if (!place_map.contains(other) || place_map.log_odds[place_map.index(other)] <= kOccupied)
        continue;
      const Point2 away = place_map.centre(other) - here;
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
  const double cell_spread = place_map.resolution_m * place_map.resolution_m / 12;
  if ((xx + yy) / 2 + half < kLine * ((xx + yy) / 2 - half + cell_spread)) return;
  const Point2 along = unit_vector(0.5 * std::atan2(2 * xy, xx - yy));
  const Point2 normal{-along.y_m, along.x_m};
  pieces_.push_back({here + dot(mean, normal) * normal, normal});
}

void PlaceWalls::spread(std::size_t piece) {
  const Point2 point = pieces_[piece].point;
  const Cell middle = frame_.cell_at(point);
  const int reach = static_cast<int>(reach_m / frame_.resolution_m);
  for (int row = std::max(0, middle.row - reach);
       row <= std::min(frame_.height - 1, middle.row + reach); ++row) {
    for (int column = std::max(0, middle.column - reach);
         column <= std::min(frame_.width - 1, middle.column + reach); ++column) {
      const Point2 centre = frame_.centre({column, row});
      int& nearest = nearest_[frame_.index({column, row})];
      const double away_m = norm(centre - point);
      if (away_m > reach_m) continue;
      if (nearest == kNone ||
          away_m < norm(centre - pieces_[static_cast<std::size_t>(nearest)].point))
        nearest = static_cast<int>(piece);
    }
  }
}

const WallPiece* PlaceWalls::nearest(Point2 in_place) const {
  const Cell cell = frame_.cell_at(in_place);
  if (!frame_.contains(cell)) return nullptr;
  const int piece = nearest_[frame_.index(cell)];
  return piece == kNone ? nullptr : &pieces_[static_cast<std::size_t>(piece)];
}

bool PlaceWalls::is_known(Point2 in_place) const {
  const Cell cell = frame_.cell_at(in_place);
  return frame_.contains(cell) && known_[frame_.index(cell)];
}

}  // namespace asterism
