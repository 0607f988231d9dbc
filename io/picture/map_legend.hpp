#pragma once

#include <cstddef>

namespace asterism {

/// A path's colour in all pictures, "#0072b2".
const char* path_colour(std::size_t path);

}  // namespace asterism
