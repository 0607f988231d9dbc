#include "io/grid/occupancy_map.hpp"

#include <array>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "io/atomic_file.hpp"
#include "io/grid/grid_file.hpp"
#include "io/text_file.hpp"

namespace asterism {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view yaml_ending = ".yaml";
constexpr std::uint8_t occupied_grey = 0;
constexpr std::uint8_t free_grey = 254;
constexpr std::uint8_t unknown_grey = 205;

std::uint8_t grey_of(float log_odds, const MapYaml& yaml) {
  const double is_occupied = 1 / (1 + std::exp(-static_cast<double>(log_odds)));
  if (is_occupied > yaml.occupied_threshold) return occupied_grey;
  return is_occupied < yaml.free_threshold ? free_grey : unknown_grey;
}

/// Of an occupied cell as read, and of a free one but for the sign.
float certain_log_odds() { return log_odds_of_grey(0); }

float log_odds_of(std::size_t grey, const MapYaml& yaml) {
  const double share = static_cast<double>(grey) / 255;
  const double is_occupied = yaml.is_negated ? share : 1 - share;
  if (is_occupied > yaml.occupied_threshold) return certain_log_odds();
  return is_occupied < yaml.free_threshold ? -certain_log_odds() : 0;
}

}  // namespace

Grid occupancy_map(const MapYaml& yaml, const GreyImage& image) {
  std::array<float, 256> log_odds{};
  for (std::size_t grey = 0; grey < log_odds.size(); ++grey)
    log_odds[grey] = log_odds_of(grey, yaml);
  return {static_cast<int>(image.width), static_cast<int>(image.height), yaml.resolution_m,
          yaml.map_from_grid, cells_of(image, log_odds)};
}

Grid read_occupancy_map_file(const std::string& file) {
  const MapYaml yaml = read_map_yaml(opened_file(file), file);
  const fs::path image = fs::path(file).parent_path() / yaml.image;  // which may be absolute
  return occupancy_map(yaml, read_pgm_file(image.string()));
}

void write_occupancy_map_file(const std::string& file, const Grid& grid) {
  require_writable(grid);
  const fs::path name = fs::path(file).filename();
  if (name.extension() != yaml_ending || name.stem().empty())
    throw std::invalid_argument(file + ": found no name that ends in .yaml; expected one");
  MapYaml yaml;
  yaml.image = name.stem().string() + ".pgm";
  yaml.resolution_m = grid.resolution_m;
  yaml.map_from_grid = grid.frame_from_grid;

  const GreyImage image = picture_of(grid, [&](float log_odds) { return grey_of(log_odds, yaml); });
  const std::string text = map_yaml(yaml);
  write_atomically((fs::path(file).parent_path() / yaml.image).string(), pgm(image));
  write_atomically(file, text);
}

}  // namespace asterism
