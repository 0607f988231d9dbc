#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "engine/ask/exits.hpp"

namespace asterism {

/// An exit to draw, by its name.
struct NamedExit {
  std::string name;
  const Exit& exit;
};

/// A picture of exits, a line each, over an axis of maps left: a disc for whatever may be seen, its
/// area the chance of that, and a bar where the number expected is. A line across marks the maps
/// there are now.
std::string exits_svg(const std::string& title, std::span<const NamedExit> exits,
                      std::uint64_t maps);

}  // namespace asterism
