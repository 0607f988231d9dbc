#include "io/grid/grid_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/grid/png_image.hpp"
#include "io/json/json_node.hpp"
#include "io/json/json_writer.hpp"
#include "io/text_file.hpp"

namespace asterism {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_json_bytes = 65536;
constexpr std::size_t max_png_bytes = 2 * max_pixels;
constexpr std::uint8_t free_grey = 254;
constexpr std::string_view json_ending = ".json";

/// A grid yet without its cells.
struct Description {
  Grid grid;
  std::string image;  ///< beside the JSON
};

/// A file beside another, and no other folder.
std::string read_image(const JsonNode& node) {
  const std::string& image = node.string();
  const auto is_strange = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == '/'; };
  if (!image.ends_with(".png") || std::ranges::any_of(image, is_strange))
    node.refuse("a PNG beside this file, like map.png");
  return image;
}

Description read_description(std::string_view json_text, const std::string& file) {
  const JsonDocument document{file, parse_json(json_text, file)};
  const JsonNode root(document);
  root.require_format("asterism/grid");
  root.require_keys({"format", "version", "resolution_m", "origin", "width", "height", "image"});
  Grid grid;
  const JsonNode resolution = root["resolution_m"];
  grid.resolution_m = resolution.number();
  if (!(grid.resolution_m > 0)) resolution.refuse("metres above 0");
  const auto origin = root["origin"].items(3, "numbers, x, y and heading");
  grid.frame_from_grid = {origin[0].number(), origin[1].number(), origin[2].number()};
  for (const char* key : {"width", "height"})
    if (root[key].count(max_pixels) == 0) root[key].refuse("at least one cell");
  grid.width = static_cast<int>(root["width"].count(max_pixels));
  grid.height = static_cast<int>(root["height"].count(max_pixels));
  return {std::move(grid), read_image(root["image"])};
}

std::string beside(const std::string& file, const std::string& name) {
  return (fs::path(file).parent_path() / name).string();
}

std::string size_text(std::size_t width, std::size_t height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

Grid filled(Description description, std::string_view png_bytes, const std::string& png_name) {
  Grid& grid = description.grid;
  const GreyImage image = read_grey_png(png_bytes, png_name);
  const auto width = static_cast<std::size_t>(grid.width);
  const auto height = static_cast<std::size_t>(grid.height);
  if (image.width != width || image.height != height)
    throw InputError(png_name, size_text(image.width, image.height) + " pixels",
                     size_text(width, height));
  const auto strange = std::ranges::find(image.greys, 255);
  if (strange != image.greys.end()) {
    const auto at = static_cast<std::size_t>(strange - image.greys.begin());
    throw InputError(png_name,
                     "grey 255 at column " + std::to_string(at % width) + ", row " +
                         std::to_string(at / width) + " from the top",
                     "at most 254");
  }
  std::array<float, free_grey + 1> log_odds;
  for (std::size_t grey = 0; grey < log_odds.size(); ++grey)
    log_odds[grey] = log_odds_of_grey(static_cast<std::uint8_t>(grey));
  grid.log_odds = cells_of(image, log_odds);
  return std::move(grid);
}

}  // namespace

void require_writable(const Grid& grid) {
  const bool has_size = grid.width > 0 && grid.height > 0 &&
                        grid.log_odds.size() == static_cast<std::size_t>(grid.width) *
                                                    static_cast<std::size_t>(grid.height);
  if (!has_size)
    throw std::invalid_argument("grid: found " + std::to_string(grid.log_odds.size()) +
                                " cells; expected " + std::to_string(grid.width) + " x " +
                                std::to_string(grid.height) + ", at least one");
  if (!(grid.resolution_m > 0))
    throw std::invalid_argument("grid: found no resolution; expected metres above 0");
  if (std::ranges::any_of(grid.log_odds, [](float cell) { return std::isnan(cell); }))
    throw std::invalid_argument("grid: found a cell that is no number; expected log-odds");
}

float log_odds_of_grey(std::uint8_t grey) {
  return static_cast<float>(std::log((free_grey + 0.5 - grey) / (grey + 0.5)));
}

std::uint8_t grey_of_log_odds(float log_odds) {
  const double is_free = 1 / (1 + std::exp(static_cast<double>(log_odds)));
  return static_cast<std::uint8_t>(
      std::clamp(std::round((free_grey + 1) * is_free - 0.5), 0.0, double{free_grey}));
}

Grid as_written(Grid grid) {
  for (float& cell : grid.log_odds) cell = log_odds_of_grey(grey_of_log_odds(cell));
  return grid;
}

Grid read_grid_file(const std::string& file) {
  Description description = read_description(read_text_file(file, max_json_bytes), file);
  const std::string image = beside(file, description.image);
  return filled(std::move(description), read_text_file(image, max_png_bytes), image);
}

Grid read_grid(std::string_view json_text, std::string_view png_bytes, const std::string& file) {
  Description description = read_description(json_text, file);
  const std::string image = beside(file, description.image);
  return filled(std::move(description), png_bytes, image);
}

void write_grid_file(const std::string& file, const Grid& grid) {
  require_writable(grid);
  const std::string stem =
      file.ends_with(json_ending) ? file.substr(0, file.size() - json_ending.size()) : "";
  const std::string image = fs::path(stem).filename().string() + ".png";
  if (image == ".png")
    throw std::invalid_argument(file + ": found no name that ends in .json; expected one");
  const std::string json = json_file("asterism/grid", [&](JsonWriter& to) {
    const auto& [x_m, y_m, heading_rad] = grid.frame_from_grid;
    to.member("resolution_m", grid.resolution_m, "origin", std::array{x_m, y_m, heading_rad});
    to.line().member("width", grid.width, "height", grid.height, "image", image);
  });
  write_png_file(beside(file, image), picture_of(grid, grey_of_log_odds));
  write_atomically(file, json);
}

}  // namespace asterism
