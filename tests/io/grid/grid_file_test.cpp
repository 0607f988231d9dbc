#include "io/grid/grid_file.hpp"

#include <cmath>
#include <limits>
#include <random>

#include "core/error.hpp"
#include "io/grid/png_image.hpp"
#include "tests/io/corpus.hpp"
#include "tests/io/folder.hpp"
#include "tests/io/grid/written_twice.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

namespace fs = std::filesystem;

std::string json(const std::string& from = "", const std::string& to = "") {
  std::string text = R"({ "format": "asterism/grid", "version": 1, "resolution_m": 0.1,
    "origin": [-1, 2.5, 0.5], "width": 3, "height": 2, "image": "map.png" })";
  if (const auto at = text.find(from); !from.empty()) text.replace(at, from.size(), to);
  return text;
}

const GreyImage picture{3, 2, {254, 127, 0, 1, 2, 3}};

std::string message_of(const std::string& json_text, const std::string& png_bytes) {
  try {
    read_grid(json_text, png_bytes, "lpm/map.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

Grid random_grid(std::mt19937_64& random) {
  Grid grid;
  grid.width = static_cast<int>(1 + random() % 40);
  grid.height = static_cast<int>(1 + random() % 40);
  grid.resolution_m = 0.01 * static_cast<double>(1 + random() % 50);
  grid.frame_from_grid = {-0.1 * static_cast<double>(random() % 1000), 1.0 / 3, -0.25};
  for (int i = 0; i < grid.width * grid.height; ++i)
    grid.log_odds.push_back(static_cast<float>(random() % 2001) / 100 - 10);
  return grid;
}

}  // namespace

TEST_CASE("a grey stands for log-odds, and they for it", "[io]") {
  CHECK(log_odds_of_grey(127) == 0);
  CHECK(grey_of_log_odds(0) == 127);
  CHECK(grey_of_log_odds(std::numeric_limits<float>::infinity()) == 0);
  CHECK(grey_of_log_odds(-std::numeric_limits<float>::infinity()) == 254);
  CHECK(log_odds_of_grey(0) == Approx(6.23).margin(0.005));
  for (int grey = 0; grey <= 254; ++grey) {
    const float log_odds = log_odds_of_grey(static_cast<std::uint8_t>(grey));
    CHECK(grey_of_log_odds(log_odds) == grey);
    CHECK(log_odds ==
          Approx(-log_odds_of_grey(static_cast<std::uint8_t>(254 - grey))).margin(1e-6));
  }
}

//   254 127  0      top row of the picture    free  unknown  occupied
//     1   2  3      bottom row: cells 0 1 2
TEST_CASE("what the two files say is in the grid", "[io]") {
  const Grid grid = read_grid(json(), png(picture), "lpm/map.json");
  CHECK(grid.width == 3);
  CHECK(grid.height == 2);
  CHECK(grid.resolution_m == 0.1);
  CHECK(grid.frame_from_grid == Pose2{-1, 2.5, 0.5});
  CHECK(grid.log_odds[grid.index({0, 1})] == log_odds_of_grey(254));
  CHECK(grid.log_odds[grid.index({1, 1})] == 0);
  CHECK(grid.log_odds[grid.index({2, 1})] == log_odds_of_grey(0));
  CHECK(grid.log_odds[grid.index({0, 0})] == log_odds_of_grey(1));
}

TEST_CASE("a grid is read as it was written, each cell to its grey", "[io][property]") {
  const auto seed = GENERATE(range(0U, 50U));
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const Grid grid = random_grid(random);
  const Folder folder;
  check_written_twice(grid, folder.file("3.json"), folder.file("3.png"), write_grid_file,
                      read_grid_file,
                      [](float log_odds) { return log_odds_of_grey(grey_of_log_odds(log_odds)); });
  CHECK(folder.entries() == 2);
}

TEST_CASE("a bad description of a grid is refused", "[io]") {
  const std::string picture_bytes = png(picture);
  const auto refusal = [&](const std::string& from, const std::string& to) {
    return message_of(json(from, to), picture_bytes);
  };
  CHECK(refusal("", "").empty());
  CHECK(refusal("asterism/grid", "asterism/map") ==
        "lpm/map.json:/format: found \"asterism/map\"; expected \"asterism/grid\"");
  CHECK(refusal("1,", "2,") == "lpm/map.json:/version: found 2; expected 1");
  CHECK(refusal("0.1", "0") == "lpm/map.json:/resolution_m: found 0; expected metres above 0");
  CHECK(refusal("0.1", "-1") == "lpm/map.json:/resolution_m: found -1; expected metres above 0");
  CHECK(refusal("0.1", "null") == "lpm/map.json:/resolution_m: found null; expected a number");
  CHECK(refusal("-1, 2.5", "-1") ==
        "lpm/map.json:/origin: found an array of 2; expected 3 numbers, x, y and heading");
  CHECK(refusal("2.5", "\"2\"") == "lpm/map.json:/origin/1: found \"2\"; expected a number");
  CHECK(refusal("\"width\": 3, ", "") ==
        "lpm/map.json:/width: found nothing; expected an integer from 0 to 16777216");
  CHECK(refusal("3", "0") == "lpm/map.json:/width: found 0; expected at least one cell");
  CHECK(refusal("3", "-3") ==
        "lpm/map.json:/width: found -3; expected an integer from 0 to 16777216");
  CHECK(refusal("3", "4") == "lpm/map.png: found 3 x 2 pixels; expected 4 x 2");
  CHECK(refusal("map.png", "../map.png") ==
        "lpm/map.json:/image: found \"../map.png\"; expected a PNG beside this file, like map.png");
  CHECK(
      refusal("map.png", "/etc/passwd") ==
      "lpm/map.json:/image: found \"/etc/passwd\"; expected a PNG beside this file, like map.png");
  CHECK(refusal("\"version\"", "\"x_note\": 1, \"version\"") ==
        "lpm/map.json:/x_note: found an unknown key; expected one of format version resolution_m "
        "origin width height image");
  CHECK(message_of("[]", picture_bytes) == "lpm/map.json: found array; expected an object");
  CHECK(message_of("", picture_bytes).starts_with("lpm/map.json:1:1: found end of input"));
}

TEST_CASE("a bad picture of a grid is refused", "[io]") {
  const auto refusal = [](const std::string& bytes) { return message_of(json(), bytes); };
  const std::string whole = png(picture);
  CHECK(refusal("") == "lpm/map.png: found another kind of file; expected a grey PNG");
  CHECK(refusal("GIF89a") == "lpm/map.png: found another kind of file; expected a grey PNG");
  CHECK(refusal(whole.substr(0, whole.size() - 1)) ==
        "lpm/map.png: found no end of a PNG; expected one at the end of the file");
  CHECK(refusal(whole + "\n") ==
        "lpm/map.png: found no end of a PNG; expected one at the end of the file");
  const fs::path corpus = fs::path(ASTERISM_SOURCE_DIR) / "tests/corpus/grid";
  CHECK(refusal(content(corpus / "bad_rgb.png")) ==
        "lpm/map.png: found colours, transparency or 16 bits; expected a grey PNG of 8 bits");
  CHECK(refusal(png({3, 2, {254, 127, 0, 1, 255, 3}})) ==
        "lpm/map.png: found grey 255 at column 1, row 1 from the top; expected at most 254");
  for (std::size_t i = 8; i < whole.size();
       ++i) {  // the signature aside, every byte has a checksum
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    INFO(i);
    CHECK(refusal(damaged) != "");
  }
  for (std::size_t cut = 8; cut + 12 < whole.size(); ++cut) {
    std::string shorter = whole;
    shorter.erase(cut, 1);
    CHECK(refusal(shorter) != "");
  }
}

TEST_CASE("pictures by other programs are read if grey, and refused if not", "[io]") {
  int good = 0, bad = 0;
  for (const auto& entry :
       fs::directory_iterator(fs::path(ASTERISM_SOURCE_DIR) / "tests/corpus/grid")) {
    const std::string name = entry.path().filename().string();
    INFO(name);
    if (!name.ends_with(".png")) continue;
    if (name.starts_with("good")) {
      ++good;
      const GreyImage image = read_grey_png(content(entry.path()), name);
      CHECK(image.greys.size() == image.width * image.height);
      if (image.width == 3 && name != "good_1_bit.png") CHECK(image.greys == picture.greys);
    } else {
      ++bad;
      CHECK_THROWS_AS(read_grey_png(content(entry.path()), name), InputError);
    }
  }
  CHECK(good >= 5);
  CHECK(bad >= 12);
}

TEST_CASE("a grid's files that are missing are told", "[io]") {
  const Folder folder;
  const std::string file = folder.file("map.json");
  CHECK_THROWS_WITH(read_grid_file(file),
                    file + ": found no such file or directory; expected a file that can be read");
  write_grid_file(file, Grid{1, 1, 0.1, {}, {0}});
  fs::remove(folder.file("map.png"));
  CHECK_THROWS_WITH(read_grid_file(file),
                    folder.file("map.png") +
                        ": found no such file or directory; expected a file that can be read");
}

TEST_CASE("a grid that could not be read back is not written", "[io]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Grid grid{2, 2, 0.1, {}, {0, 1, 2, 3}};
  const Folder folder;
  std::string file = folder.file("map.json");
  SECTION("no name") { file = folder.file(".json"); }
  SECTION("another kind") { file = folder.file("map.png"); }
  SECTION("no cell") { grid = {0, 0, 0.1, {}, {}}; }
  SECTION("too few cells") { grid.log_odds.pop_back(); }
  SECTION("negative size") { grid.width = grid.height = -2; }
  SECTION("no resolution") { grid.resolution_m = 0; }
  SECTION("resolution infinite") { grid.resolution_m = HUGE_VAL; }
  SECTION("origin no number") { grid.frame_from_grid.y_m = nan; }
  SECTION("cell no number") { grid.log_odds[2] = std::numeric_limits<float>::quiet_NaN(); }
  CHECK_THROWS_AS(write_grid_file(file, grid), std::invalid_argument);
  CHECK(folder.entries() == 0);
}

TEST_CASE("pictures are written grey", "[io]") {
  const Folder folder;
  write_png_file(folder.file("a.png"), picture);
  CHECK(read_grey_png(content(folder.file("a.png")), "a.png").greys == picture.greys);
  CHECK_THROWS_AS(png({1, 1, {1, 2}}), std::invalid_argument);
  CHECK_THROWS_AS(png({0, 1, {}}), std::invalid_argument);
  CHECK_THROWS_AS(png({2, 1, {1}}), std::invalid_argument);
}

}  // namespace asterism
