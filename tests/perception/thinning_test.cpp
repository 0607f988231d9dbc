#include "perception/thinning.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "core/random.hpp"
#include "tests/perception/plain_thinning.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

// Pictures as text, the top line the northernmost row.
struct Drawing {
  Picture picture = {};
  int width = 0;
  int height = 0;
};

Drawing drawn(const std::vector<std::string>& lines) {
  Drawing drawing{.width = static_cast<int>(lines.front().size()),
                  .height = static_cast<int>(lines.size())};
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
    for (const char letter : *line) drawing.picture.push_back(letter == '#');
  }
  return drawing;
}

std::vector<std::string> text(const Picture& picture, int width, int height) {
  std::vector<std::string> lines(static_cast<std::size_t>(height));
  const auto columns = static_cast<std::size_t>(width);
  for (std::size_t i = 0; i < picture.size(); ++i) {
    lines[lines.size() - 1 - i / columns] += picture[i] != 0 ? '#' : '.';
  }
  return lines;
}

// Speckle, or blobs and strokes that take several turns to thin.
Picture random_picture(int width, int height, RandomEngine& random) {
  const auto columns = static_cast<std::size_t>(width);
  const auto rows = static_cast<std::size_t>(height);
  Picture picture(columns * rows, 0);
  if (chance(0.4, random)) {
    const double share = uniform(random);
    for (std::uint8_t& cell : picture) cell = chance(share, random);
    return picture;
  }
  for (std::size_t blob = 2 + below(10, random); blob > 0; --blob) {
    const std::size_t left = below(columns, random);
    const std::size_t low = below(rows, random);
    const std::size_t right = std::min(columns, left + 1 + below(columns / 2 + 1, random));
    const std::size_t high = std::min(rows, low + 1 + below(rows / 2 + 1, random));
    const bool round = chance(0.5, random);
    for (std::size_t row = low; row < high; ++row) {
      for (std::size_t column = left; column < right; ++column) {
        const double x =
            (2.0 * static_cast<double>(column - left) + 1) / static_cast<double>(right - left) - 1;
        const double y =
            (2.0 * static_cast<double>(row - low) + 1) / static_cast<double>(high - low) - 1;
        if (!round || x * x + y * y <= 1) picture[row * columns + column] = 1;
      }
    }
  }
  return picture;
}

Picture thinned(const Picture& picture, int width, int height) {
  return picture_of(thinned(bit_rows(picture, width, height)));
}

std::size_t count(const Picture& picture) {
  return static_cast<std::size_t>(std::count(picture.begin(), picture.end(), 1));
}

// What a piece was before its last cells went at once.
bool was_a_block(const Picture& piece, int width) {
  const auto first =
      static_cast<std::size_t>(std::find(piece.begin(), piece.end(), 1) - piece.begin());
  const auto columns = static_cast<std::size_t>(width);
  return count(piece) == 4 && piece[first + 1] && piece[first + columns] &&
         piece[first + columns + 1];
}

}  // namespace

TEST_CASE("thinning by words is thinning cell by cell", "[perception][property]") {
  const int width = GENERATE(1, 2, 3, 17, 62, 63, 64, 65, 66, 127, 128, 129, 130, 192);
  RandomEngine random(static_cast<RandomEngine::result_type>(width));
  for (int picture = 0; picture < 60; ++picture) {
    const int height = 1 + static_cast<int>(below(70, random));
    CAPTURE(width, height, picture);
    const Picture figure = random_picture(width, height, random);
    REQUIRE(thinned(figure, width, height) == plain_thinning(figure, width, height).back());
  }
}

// Worked by hand. The first subiteration takes the south, the east and the north-west corner, the
// second the north, the west and the south-east corner; what is left has no more than one neighbour
// a cell, or two of which none may go:
//
//   # # # # #        . # # # .        . . . . .
//   # # # # #   →    # # # # .   →    . # # . .
//   # # # # #        . . . . .        . . . . .
TEST_CASE("thinning comes to what the conditions give by hand", "[perception]") {
  using Lines = std::vector<std::string>;
  const auto [given, expected] = GENERATE(table<Lines, Lines>({
      {{"#####", "#####", "#####"}, {".....", ".##..", "....."}},
      {{"##", "##"}, {"..", ".."}},  // vanishes, as is known of [ZS84]
      {{"###", "###", "###"}, {"...", ".#.", "..."}},
      {{"#"}, {"#"}},
      {{"#####"}, {"#####"}},
      // Two cells wide: the first subiteration takes the south, the east and the north-west
      // corner; then each end has one neighbour.
      {{"#####", "#####"}, {".###.", "....."}},
      // An H of lines one cell wide is its own skeleton: A = 3 where they meet.
      {{"#...#", "#...#", "#####", "#...#", "#...#"},
       {"#...#", "#...#", "#####", "#...#", "#...#"}},
      // So are a step and a ring: A = 2 at a corner.
      {{"###..", "..#..", "..###"}, {"###..", "..#..", "..###"}},
      {{"####", "#..#", "#..#", "####"}, {"####", "#..#", "#..#", "####"}},
  }));
  const auto [picture, width, height] = drawn(given);
  CHECK(text(plain_thinning(picture, width, height).back(), width, height) == expected);
  CHECK(text(thinned(picture, width, height), width, height) == expected);
}

TEST_CASE("a thick H thins to an H across the border of two words", "[perception]") {
  std::vector<std::string> lines;
  for (int row = 0; row < 25; ++row) {
    lines.push_back(std::string(60, '.') + "#####" +
                    std::string(9, row >= 10 && row < 15 ? '#' : '.') + "#####" +
                    std::string(10, '.'));
  }
  const auto [picture, width, height] = drawn(lines);
  const std::vector<std::string> thin = text(thinned(picture, width, height), width, height);
  for (std::size_t row = 3; row < 22; ++row) {
    const std::string& line = thin[row];
    CAPTURE(row, line);
    // Away from the crossbar each leg is one cell, in its middle.
    if (row < 8 || row > 16) {
      CHECK(std::count(line.begin(), line.end(), '#') == 2);
      CHECK(line[62] == '#');
      CHECK(line[76] == '#');
    }
  }
  CHECK(thin[12].substr(66, 7) == "#######");
  CHECK(thin[11].substr(66, 7) == ".......");
  CHECK(thin[13].substr(66, 7) == ".......");
}

TEST_CASE("thinning keeps pieces and holes but for blocks of four", "[perception][property]") {
  RandomEngine random(3);
  std::size_t kept = 0;
  std::size_t vanished = 0;
  for (int seed = 0; seed < 300; ++seed) {
    const int width = 1 + static_cast<int>(below(70, random));
    const int height = 1 + static_cast<int>(below(50, random));
    const Picture figure = random_picture(width, height, random);
    const Picture lines = thinned(figure, width, height);
    const std::vector<int> before = pieces_of(figure, width, height);
    const std::vector<int> after = pieces_of(lines, width, height);
    const int pieces = *std::max_element(before.begin(), before.end());
    for (int piece = 1; piece <= pieces; ++piece) {
      CAPTURE(seed, width, height, piece);
      std::set<int> becomes;
      Picture alone(figure.size(), 0);
      for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i] != piece) continue;
        alone[i] = 1;
        if (after[i] != 0) becomes.insert(after[i]);
      }
      REQUIRE(becomes.size() <= 1);
      kept += becomes.size();
      if (!becomes.empty()) continue;
      ++vanished;
      const auto stages = plain_thinning(alone, width, height);
      REQUIRE(was_a_block(stages[stages.size() - 2], width));
    }
    const std::vector<int> holes = pieces_of(figure, width, height, false);
    const std::vector<int> left = pieces_of(lines, width, height, false);
    for (std::size_t i = 0; i < holes.size(); ++i) {
      // Cells outside the figure in one hole stay in one, and in different ones stay apart.
      if (holes[i] == 0) continue;
      const auto same =
          static_cast<std::size_t>(std::find(holes.begin(), holes.end(), holes[i]) - holes.begin());
      REQUIRE(left[i] == left[same]);
    }
  }
  CHECK(kept > 1000);
  CHECK(vanished > 0);
}

TEST_CASE("what is thinned is thin, and stays as it is", "[perception][property]") {
  RandomEngine random(4);
  for (int seed = 0; seed < 200; ++seed) {
    const int width = 1 + static_cast<int>(below(140, random));
    const int height = 1 + static_cast<int>(below(60, random));
    const Picture figure = random_picture(width, height, random);
    const Picture lines = thinned(figure, width, height);
    CAPTURE(seed, width, height);
    REQUIRE(thinned(lines, width, height) == lines);
    for (std::size_t i = 0; i < lines.size(); ++i) REQUIRE(lines[i] <= (figure[i] != 0));
  }
}

// Of a diagonal two cells wide the ends are taken again and again, until next to nothing is left.
//
//   . . . . # #
//   . . . # # .
//   . . # # . .
//   . # # . . .
//   # # . . . .
TEST_CASE("anchors stay, and what joins them", "[perception][property]") {
  BitRows diagonal(140, 140);
  for (int i = 0; i < 139; ++i) diagonal.set_run(i, i, i + 2);
  CHECK(count(picture_of(thinned(diagonal))) <= 2);
  BitRows ends(140, 140);
  ends.set({0, 0});
  ends.set({139, 138});
  const BitRows kept = thinned(diagonal, ends);
  CHECK(kept.has({0, 0}));
  CHECK(kept.has({139, 138}));
  CHECK(Pieces(kept, Pieces::Touch::corners).count() == 1);

  RandomEngine random(5);
  for (int seed = 0; seed < 200; ++seed) {
    const int width = 1 + static_cast<int>(below(140, random));
    const int height = 1 + static_cast<int>(below(60, random));
    const BitRows figure = bit_rows(random_picture(width, height, random), width, height);
    BitRows anchors(width, height);
    figure.for_each([&](Cell cell) {
      if (chance(0.01, random)) anchors.set(cell);
    });
    const BitRows lines = thinned(figure, anchors);
    CAPTURE(seed, width, height);
    // A piece with an anchor stays one piece, and all its anchors are in it.
    const Pieces before(figure, Pieces::Touch::corners);
    const Pieces after(lines, Pieces::Touch::corners);
    std::map<std::size_t, std::set<std::size_t>> becomes;
    anchors.for_each([&](Cell cell) {
      REQUIRE(lines.has(cell));
      becomes[*before.at(cell)].insert(*after.at(cell));
    });
    lines.for_each([&](Cell cell) {
      REQUIRE(figure.has(cell));
      becomes[*before.at(cell)].insert(*after.at(cell));
    });
    for (const auto& [piece, parts] : becomes) REQUIRE(parts.size() == 1);
  }
}

}  // namespace asterism
