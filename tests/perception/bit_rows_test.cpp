#include "perception/bit_rows.hpp"

#include <algorithm>

#include "core/random.hpp"
#include "tests/perception/plain_thinning.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

Picture speckle(int width, int height, double share, RandomEngine& random) {
  Picture picture(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::uint8_t& cell : picture) cell = chance(share, random);
  return picture;
}

}  // namespace

TEST_CASE("rows of bits hold what was set, and nothing outside", "[perception]") {
  const int width = GENERATE(1, 63, 64, 65, 128, 130);
  RandomEngine random(1);
  const Picture picture = speckle(width, 20, 0.5, random);
  BitRows rows = bit_rows(picture, width, 20);
  CHECK(picture_of(rows) == picture);
  for (int at = -2; at < width + 2; ++at) {
    CHECK_FALSE(rows.has({at, -1}));
    CHECK_FALSE(rows.has({at, 20}));
  }
  CHECK_FALSE(rows.has({-1, 3}));
  CHECK_FALSE(rows.has({width, 3}));

  std::vector<Cell> cells;
  rows.for_each([&](Cell cell) { cells.push_back(cell); });
  CHECK(cells.size() == static_cast<std::size_t>(std::count(picture.begin(), picture.end(), 1)));
  CHECK(std::is_sorted(cells.begin(), cells.end(), [](Cell a, Cell b) {
    return a.row != b.row ? a.row < b.row : a.column < b.column;
  }));
  for (const Cell cell : cells) rows.clear(cell);
  CHECK(rows == BitRows(width, 20));
}

TEST_CASE("a run of cells is set across words", "[perception]") {
  const int first = GENERATE(0, 1, 60, 63, 64, 65, 127, 128);
  for (int past = first + 1; past <= 200; ++past) {
    BitRows rows(200, 3);
    rows.set_run(1, first, past);
    CAPTURE(first, past);
    int set = 0;
    rows.for_each([&](Cell cell) {
      ++set;
      REQUIRE(cell.row == 1);
      REQUIRE(cell.column >= first);
      REQUIRE(cell.column < past);
    });
    REQUIRE(set == past - first);
  }
}

TEST_CASE("pieces are those of a search cell by cell", "[perception][property]") {
  RandomEngine random(2);
  for (int round = 0; round < 300; ++round) {
    const int width = 1 + static_cast<int>(below(140, random));
    const int height = 1 + static_cast<int>(below(40, random));
    const Picture picture = speckle(width, height, uniform(random), random);
    const BitRows rows = bit_rows(picture, width, height);
    CAPTURE(round, width, height);
    const Pieces corners(rows, Pieces::Touch::corners);
    const std::vector<int> expected = pieces_of(picture, width, height);
    REQUIRE(static_cast<int>(corners.count()) ==
            *std::max_element(expected.begin(), expected.end()));

    // The search joins cells outside a figure by their sides.
    Picture others = picture;
    for (std::uint8_t& cell : others) cell = cell == 0;
    const Pieces sides(rows, Pieces::Touch::sides);
    const std::vector<int> expected_sides = pieces_of(others, width, height, false);
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        const auto at = static_cast<std::size_t>(row * width + column);
        const auto number = [&](const Pieces& pieces) {
          const auto piece = pieces.at({column, row});
          return piece ? static_cast<int>(*piece) + 1 : 0;
        };
        REQUIRE(number(corners) == expected[at]);
        REQUIRE(number(sides) == expected_sides[at]);
      }
    }
    REQUIRE_FALSE(corners.at({-1, 0}));
    REQUIRE_FALSE(corners.at({0, height}));
  }
}

}  // namespace asterism
