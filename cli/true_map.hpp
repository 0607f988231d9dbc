#pragma once

#include <string>

#include "simulation/walk.hpp"

namespace asterism {

/// Writes the truth as a maps file of one map.  @throws Error if the file cannot be written
void write_true_map(const std::string& file, const Walk& walk);

}  // namespace asterism
