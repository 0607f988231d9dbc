#pragma once

#include "cli/options.hpp"
#include "core/experience.hpp"

namespace asterism {

/// `asterism map` of an experience of the basic SSH.
/// @return exit code
int map_experience(MapCommand& command, const Experience& experience);

}  // namespace asterism
