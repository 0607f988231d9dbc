#include <cmath>
#include <sstream>

#include "io/grid/occupancy_map.hpp"
#include "tests/support/fuzz.hpp"

namespace {

using namespace asterism;

MapYaml read(const std::string& text, const std::string& name) {
  return read_map_yaml(std::make_unique<std::istringstream>(text), name);
}

}  // namespace

/// Any text is the YAML of a map or refused; it can be written, if the name of its picture has no
/// character that needs an escape, and is read back as it is.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz_input(data, size);
  const auto yaml = accepted("input", [&] { return read(text, "input"); });
  if (!yaml) return 0;
  const Grid grid = occupancy_map(*yaml, {2, 1, {0, 254}});
  require(grid.log_odds.size() == 2 && grid.resolution_m > 0);
  if (yaml->image.find_first_of("\"\\") != std::string::npos) return 0;
  const MapYaml again = read(map_yaml(*yaml), "written");
  require(again.image == yaml->image && again.resolution_m == yaml->resolution_m);
  require(again.map_from_grid == yaml->map_from_grid && again.is_negated == yaml->is_negated);
  require(again.occupied_threshold == yaml->occupied_threshold);
  require(again.free_threshold == yaml->free_threshold);
  return 0;
}
