#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/grid.hpp"

namespace asterism {

/// A grid is two files: a JSON, and beside it the grey PNG that it names, top row first.
///
///   { "format": "asterism/grid", "version": 1, "resolution_m": 0.1, "origin": [-15, -15, 0],
///     "width": 300, "height": 300, "image": "0.png" }
///
/// The origin is the pose of the lower left corner: x, y, heading.
/// A grey g from 0 to 254 stands for the odds of an obstacle, (254.5 - g) : (g + 0.5): 0 is black
/// and occupied, 254 is white and free, 127 is unknown. So log-odds beyond ±6.23 are cut to that,
/// and each other one to the nearest grey; what was read is written again without loss.

/// The logarithm of the odds that a grey stands for.  @pre grey <= 254
float log_odds_of_grey(std::uint8_t grey);

/// The grey nearest in probability.  @pre not NaN
std::uint8_t grey_of_log_odds(float log_odds);

/// The grid that will be read where this one is written: log-odds of 255 greys.
Grid as_written(Grid grid);

/// Throws std::invalid_argument unless a grid has cells, as many as it says, a resolution and
/// log-odds that are numbers.
void require_writable(const Grid& grid);

/// Reads a grid from its two files.
/// @param file  the JSON
/// @throws InputError "file: found ...; expected ...", strictly: no unknown keys, the PNG of just
///         that size, no grey 255
Grid read_grid_file(const std::string& file);

/// Reads a grid from what its two files hold.
/// @param file  the JSON, for messages
Grid read_grid(std::string_view json_text, std::string_view png_bytes, const std::string& file);

/// Writes NAME.json and NAME.png beside it, the PNG first: each whole or not at all.
/// @param file  the JSON; ends in .json
/// @throws std::invalid_argument if the grid could not be read back or `file` ends otherwise, Error
///         if a file cannot be written
void write_grid_file(const std::string& file, const Grid& grid);

}  // namespace asterism
