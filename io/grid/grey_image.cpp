#include "io/grid/grey_image.hpp"

#include <stdexcept>
#include <string>

namespace asterism {

void require_fit(const GreyImage& image) {
  const auto& [width, height, greys] = image;
  if (width < 1 || height < 1 || width > max_pixels || height > max_pixels / width ||
      greys.size() != width * height)
    throw std::invalid_argument(
        "image: found " + std::to_string(width) + " x " + std::to_string(height) + " pixels in " +
        std::to_string(greys.size()) + " bytes; expected a picture that fills them");
}

std::vector<float> cells_of(const GreyImage& image, std::span<const float> log_odds_of_grey) {
  std::vector<float> cells;
  cells.reserve(image.greys.size());
  for (std::size_t row = image.height; row-- > 0;)
    for (std::size_t column = 0; column < image.width; ++column)
      cells.push_back(log_odds_of_grey[image.greys[row * image.width + column]]);
  return cells;
}

}  // namespace asterism
