#include <cmath>
#include <sstream>

#include "io/log/relations_file.hpp"
#include "tests/support/fuzz.hpp"

/// Any bytes are relations as they must be, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asterism;
  const auto relations = accepted("input", [&] {
    return read_relations(std::make_unique<std::istringstream>(fuzz_input(data, size)), "input");
  });
  if (!relations) return 0;
  require(!relations->empty());
  for (const auto& [first_s, second_s, pose] : *relations) {
    require(std::isfinite(first_s) && std::isfinite(second_s));
    require(std::isfinite(pose.x_m + pose.y_m) && std::abs(pose.heading_rad) <= 3.1416);
  }
  return 0;
}
