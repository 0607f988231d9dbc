#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace asterism {

/// A picture of 8 bits a channel, row by row from the top, each from the left:
/// bytes[(row · width + column) · channels].
struct PngImage {
  std::size_t width = 0;
  std::size_t height = 0;
  std::size_t channels = 1;  ///< 1: grey, 0 black, 255 white; 3: red, green, blue
  std::vector<std::uint8_t> bytes = {};
};

/// As many pixels as a picture or a grid may have: a building of 400 m in cells of 0.1 m.
inline constexpr std::size_t max_pixels = std::size_t{1} << 24;

/// The content of a PNG file. Same picture, same bytes.
/// @throws std::invalid_argument unless it has 1 to max_pixels pixels, 1 or 3 channels and all
/// bytes
std::string png(const PngImage& image);

/// Whole or not at all.
/// @throws std::invalid_argument as above, Error if the file cannot be written
void write_png_file(const std::string& file, const PngImage& image);

/// Reads a grey PNG of up to 8 bits, strictly: no colours, no transparency, undamaged to its end.
/// @param file_name  for messages
/// @throws InputError "file: found ...; expected ..."
PngImage read_grey_png(std::string_view content, const std::string& file_name);

}  // namespace asterism
