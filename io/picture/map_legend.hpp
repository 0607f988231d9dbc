#pragma once

#include <cstddef>
#include <string>

namespace asterism {

/// A path's colour in all pictures, "#0072b2".
const char* path_colour(std::size_t path);

/// What tells a path from another of its colour: a stripe along the middle of its line, as
/// attributes of one to be drawn over it; empty for the first of a colour.
std::string path_stripe(std::size_t path, double line_width);

}  // namespace asterism
