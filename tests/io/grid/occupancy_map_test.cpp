#include "io/grid/occupancy_map.hpp"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <numbers>
#include <sstream>

#include "core/error.hpp"
#include "core/random.hpp"
#include "io/grid/grid_file.hpp"
#include "tests/io/corpus.hpp"
#include "tests/io/folder.hpp"
#include "tests/io/grid/written_twice.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

namespace fs = std::filesystem;

MapYaml yaml_of(const std::string& text) {
  return read_map_yaml(std::make_unique<std::istringstream>(text), "map.yaml");
}

void write(const std::string& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

Grid random_grid(RandomEngine& random) {
  Grid grid;
  grid.width = static_cast<int>(1 + below(40, random));
  grid.height = static_cast<int>(1 + below(40, random));
  grid.resolution_m = between(0.001, 2, random);
  grid.frame_from_grid = {between(-1e3, 1e3, random), 1e-7 * uniform(random),
                          between(-std::numbers::pi, std::numbers::pi, random)};
  for (int i = 0; i < grid.width * grid.height; ++i)
    grid.log_odds.push_back(static_cast<float>(between(-4, 4, random)));
  return grid;
}

/// What map_server makes of a cell: p > 0.65 occupied, p < 0.196 free.
float class_of(float log_odds) {
  const double odds = std::exp(static_cast<double>(log_odds));
  const double is_occupied = odds / (1 + odds);
  if (is_occupied > 0.65) return log_odds_of_grey(0);
  return is_occupied < 0.196 ? -log_odds_of_grey(0) : 0;
}

}  // namespace

//   254 205   0      free  unknown  occupied
//     1   2 255
TEST_CASE("a PGM is read however it is written", "[io]") {
  for (const auto& file : good_files("pgm")) {
    INFO(file);
    const GreyImage image = read_pgm_file(file);
    CHECK(image.width == 3);
    CHECK(image.height == 2);
    CHECK(image.greys == std::vector<std::uint8_t>{254, 205, 0, 1, 2, 255});
    CHECK(read_pgm(pgm(image), "again").greys == image.greys);
  }
  CHECK(pgm({1, 2, {7, 255}}) == "P5\n1 2\n255\n\7\xff");
}

TEST_CASE("what the YAML of a map says is read", "[io]") {
  for (const auto& file : good_files("yaml")) {
    INFO(file);
    const MapYaml yaml = yaml_of(content(file));
    CHECK(yaml.resolution_m == 0.05);
    CHECK(yaml.map_from_grid == Pose2{-27.25, -48.5, 0});
    CHECK(yaml.occupied_threshold == 0.65);
    const std::string name = file.filename().string();
    CHECK(yaml.is_negated == (name == "comments.yaml"));
    CHECK(yaml.free_threshold == (name == "nav2.yaml" ? 0.25 : 0.196));
    CHECK(yaml.image == (name == "comments.yaml"    ? "the map.pgm"
                         : name == "elsewhere.yaml" ? "../maps/a#b.pgm"
                                                    : "map.pgm"));
    CHECK(map_yaml(yaml_of(map_yaml(yaml))) == map_yaml(yaml));
  }
}

TEST_CASE("greys are occupied, free or unknown as map_server has it", "[io]") {
  MapYaml yaml;
  yaml.resolution_m = 0.5;
  const GreyImage image{4, 2, {0, 89, 90, 204, 205, 206, 254, 255}};
  const float c = log_odds_of_grey(0);
  // Above 0.65 of 255: 0 to 89; below 0.196: from 206 on.
  CHECK(occupancy_map(yaml, image).log_odds == std::vector<float>{0, -c, -c, -c, c, c, 0, 0});
  yaml.is_negated = true;
  CHECK(occupancy_map(yaml, image).log_odds == std::vector<float>{c, c, c, c, -c, 0, 0, c});
}

TEST_CASE("a map is written as map_server and nav2 read it", "[io]") {
  const Folder folder;
  const std::string file = folder.file("map.yaml");
  //   occupied  unknown      top row
  //   free      unknown
  write_occupancy_map_file(file, Grid{2, 2, 0.05, {-1.5, 2, 0}, {-2, -1, 1, 0.5}});
  CHECK(folder.entries() == 2);
  CHECK(content(file) ==
        "image: map.pgm\nmode: trinary\nresolution: 0.05\norigin: [-1.5, 2, 0]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  CHECK(content(folder.file("map.pgm")) == std::string("P5\n2 2\n255\n\0\xcd\xfe\xcd", 15));
}

TEST_CASE("a map is read as it was written, each cell to its class", "[io][property]") {
  RandomEngine random(GENERATE(range(0U, 40U)));
  const Grid grid = random_grid(random);
  const Folder folder;
  check_written_twice(grid, folder.file("the map, twice.yaml"), folder.file("the map, twice.pgm"),
                      write_occupancy_map_file, read_occupancy_map_file, class_of);
}

TEST_CASE("the picture of a map is looked for from its YAML", "[io]") {
  const Folder folder;
  const std::string file = folder.file("map.yaml");
  write_occupancy_map_file(file, Grid{1, 1, 1, {}, {3}});
  fs::create_directory(folder.file("pictures"));
  fs::rename(folder.file("map.pgm"), folder.file("pictures/one.pgm"));
  CHECK_THROWS_WITH(read_occupancy_map_file(file),
                    folder.file("map.pgm") +
                        ": found no such file or directory; expected a file that can be read");
  for (const std::string& image :
       {std::string("pictures/one.pgm"), folder.file("pictures/one.pgm")}) {
    MapYaml yaml;
    yaml.image = image;
    yaml.resolution_m = 1;
    write(file, map_yaml(yaml));
    CHECK(read_occupancy_map_file(file).log_odds == std::vector<float>{log_odds_of_grey(0)});
  }
}

TEST_CASE("a map that could not be read back is not written", "[io]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Grid grid{2, 2, 0.1, {}, {0, 1, 2, 3}};
  const Folder folder;
  std::string file = folder.file("map.yaml");
  SECTION("no name") { file = folder.file(".yaml"); }
  SECTION("another kind") { file = folder.file("map.json"); }
  SECTION("a quote in its name") { file = folder.file("a\"b.yaml"); }
  SECTION("a line end in its name") { file = folder.file("a\nb.yaml"); }
  SECTION("no cell") { grid = {0, 0, 0.1, {}, {}}; }
  SECTION("too few cells") { grid.log_odds.pop_back(); }
  SECTION("no resolution") { grid.resolution_m = 0; }
  SECTION("resolution infinite") { grid.resolution_m = HUGE_VAL; }
  SECTION("origin no number") { grid.frame_from_grid.y_m = nan; }
  SECTION("cell no number") { grid.log_odds[2] = std::numeric_limits<float>::quiet_NaN(); }
  CHECK_THROWS_AS(write_occupancy_map_file(file, grid), std::invalid_argument);
  CHECK(folder.entries() == 0);
  CHECK_THROWS_AS(pgm({0, 1, {}}), std::invalid_argument);
  CHECK_THROWS_AS(pgm({2, 1, {1}}), std::invalid_argument);
}

TEST_CASE("the maps of real buildings are read whole", "[io]") {
  const char* const data = std::getenv("ASTERISM_DATA");
  const fs::path folder =
      (data ? fs::path(data) : fs::path(ASTERISM_SOURCE_DIR).parent_path() / "shared/data") /
      "grids";
  struct Building {
    std::string name;
    int width, height;
  };
  const auto building = GENERATE(
      values<Building>({{"aces", 1174, 1154}, {"intel", 625, 623}, {"seattle", 1087, 371}}));
  if (!fs::exists(folder)) {
    WARN(folder << ": not here, not read");
    return;
  }
  const MapYaml yaml = yaml_of(content(folder / (building.name + ".yaml")));
  CHECK(yaml.image == building.name + ".pgm");
  const GreyImage image = read_pgm_file((folder / (yaml.image + ".xz")).string());
  const Grid grid = occupancy_map(yaml, image);
  CHECK(grid.width == building.width);
  CHECK(grid.height == building.height);
  CHECK(grid.resolution_m == 0.05);
  // Written by others, written by us: not a byte is another.
  const Folder own;
  write_occupancy_map_file(own.file("map.yaml"), grid);
  CHECK(content(own.file("map.pgm")) == pgm(image));
}

}  // namespace asterism
