#pragma once

#include <compare>
#include <string>
#include <vector>

namespace asterism {

/// A ground atom as given from outside: a relation of constants.
struct Fact {
  std::string relation;
  std::vector<std::string> arguments;
  friend auto operator<=>(const Fact&, const Fact&) = default;
};

}  // namespace asterism
