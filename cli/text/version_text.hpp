#pragma once

#include <string>

namespace asterism {

/// Versions of asterism and its libraries, a line each.
std::string version_text();

}  // namespace asterism
