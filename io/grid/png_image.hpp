#pragma once

#include <string>
#include <string_view>

#include "io/grid/grey_image.hpp"

namespace asterism {

/// The content of a PNG file. Same picture, same bytes.
/// @throws std::invalid_argument unless it has 1 to max_pixels pixels, all there
std::string png(const GreyImage& image);

/// Writes a PNG file, whole or not at all.
/// @throws std::invalid_argument as png, Error if the file cannot be written
void write_png_file(const std::string& file, const GreyImage& image);

/// Reads a grey PNG of up to 8 bits, strictly: no colours, no transparency, undamaged to its end.
/// @param file_name  for messages
/// @throws InputError "file: found ...; expected ..."
GreyImage read_grey_png(std::string_view content, const std::string& file_name);

}  // namespace asterism
