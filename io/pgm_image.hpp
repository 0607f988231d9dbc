#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace asterism {

/// A grey picture, row by row from the top, each from the left: greys[row · width + column]; 0 is
/// black, 255 white.
struct PgmImage {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint8_t> greys = {};
};

/// Reads a PGM, strictly: P5 (bytes) or P2 (decimals), comments in its head, a greatest grey of
/// 255, at most max_pixels (io/png_image.hpp) and just as many as it says.
/// @param file_name  for messages
/// @throws InputError "file: found ...; expected ..."
PgmImage read_pgm(std::string_view content, const std::string& file_name);

/// The same of a file, which may be packed by gzip or xz; its content tells.
/// @throws InputError as above, and if the file cannot be read
PgmImage read_pgm_file(const std::string& file);

/// The content of a PGM file, P5.
/// @throws std::invalid_argument unless it has 1 to max_pixels pixels, all there
std::string pgm(const PgmImage& image);

}  // namespace asterism
