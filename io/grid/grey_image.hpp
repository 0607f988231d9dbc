#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/grid.hpp"

namespace asterism {

/// A grey picture, row by row from the top, each from the left: greys[row · width + column]; 0 is
/// black, 255 white.
struct GreyImage {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint8_t> greys = {};
};

/// As many pixels as a picture or a grid may have: a building of 400 m in cells of 0.1 m.
inline constexpr std::size_t max_pixels = std::size_t{1} << 24;

/// Throws std::invalid_argument unless a picture has 1 to max_pixels pixels, all there.
void require_fit(const GreyImage& image);

/// A picture of a grid's cells from `first` to before `end`, +y up.
/// @param grey_of  the grey of log-odds
template <class GreyOf>
GreyImage picture_of(const Grid& grid, Cell first, Cell end, GreyOf grey_of) {
  GreyImage image{static_cast<std::size_t>(end.column - first.column),
                  static_cast<std::size_t>(end.row - first.row)};
  image.greys.reserve(image.width * image.height);
  // Cells are often as the one before, and a grey may take an exponential.
  float last = std::numeric_limits<float>::quiet_NaN();
  std::uint8_t grey = 0;
  for (int row = end.row; row-- > first.row;) {
    for (int column = first.column; column < end.column; ++column) {
      const float log_odds = grid.log_odds[grid.index({column, row})];
      if (log_odds != last) grey = grey_of(last = log_odds);
      image.greys.push_back(grey);
    }
  }
  return image;
}

/// A picture of all cells of a grid.
template <class GreyOf>
GreyImage picture_of(const Grid& grid, GreyOf grey_of) {
  return picture_of(grid, {}, {grid.width, grid.height}, grey_of);
}

/// The cells that a picture shows, in the order of a grid.
/// @param log_odds_of_grey  one for each grey in the picture
std::vector<float> cells_of(const GreyImage& image, std::span<const float> log_odds_of_grey);

}  // namespace asterism
