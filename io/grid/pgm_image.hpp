#pragma once

#include <string>
#include <string_view>

#include "io/grid/grey_image.hpp"

namespace asterism {

/// Reads a PGM, strictly: P5 (bytes) or P2 (decimals), comments in its head, a greatest grey of
/// 255, at most max_pixels (io/grey_image.hpp) and just as many as it says.
/// @param file_name  for messages
/// @throws InputError "file: found ...; expected ..."
GreyImage read_pgm(std::string_view content, const std::string& file_name);

/// Reads a PGM file, strictly, which may be packed by gzip or xz; its content tells.
/// @throws InputError as read_pgm, and if the file cannot be read
GreyImage read_pgm_file(const std::string& file);

/// The content of a PGM file, P5.
/// @throws std::invalid_argument unless it has 1 to max_pixels pixels, all there
std::string pgm(const GreyImage& image);

}  // namespace asterism
