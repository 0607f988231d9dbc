#pragma once

#include <string>

#include "core/grid.hpp"
#include "tests/io/corpus.hpp"
#include "tests/support/catch.hpp"

namespace asterism {

/// Checks that a grid, written to a file and read from it, is itself but for its cells, which are
/// what `as_read` makes of them; and that what was read is written to the same bytes.
///
/// @param picture  the file beside it that holds the cells
template <class Write, class Read, class AsRead>
void check_written_twice(const Grid& grid, const std::string& file, const std::string& picture,
                         Write write, Read read, AsRead as_read) {
  write(file, grid);
  const Grid again = read(file);
  CHECK(again.width == grid.width);
  CHECK(again.height == grid.height);
  CHECK(again.resolution_m == grid.resolution_m);
  CHECK(again.frame_from_grid == grid.frame_from_grid);
  REQUIRE(again.log_odds.size() == grid.log_odds.size());
  for (std::size_t i = 0; i < grid.log_odds.size(); ++i)
    CHECK(again.log_odds[i] == as_read(grid.log_odds[i]));

  const std::string picture_bytes = content(picture);
  const std::string text = content(file);
  write(file, again);
  CHECK(content(picture) == picture_bytes);
  CHECK(content(file) == text);
}

}  // namespace asterism
