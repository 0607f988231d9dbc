#include "perception/sight_lines.hpp"

#include <numbers>

#include "core/random.hpp"
#include "tests/support/catch.hpp"

namespace asterism {

TEST_CASE("looking along a line skips no cell that is not free", "[perception][property]") {
  RandomEngine random(1);
  for (int world = 0; world < 30; ++world) {
    Grid grid{.width = 90,
              .height = 70,
              .resolution_m = between(0.05, 0.2, random),
              .frame_from_grid = {between(-9, 9, random), between(-9, 9, random),
                                  between(-3, 3, random)}};
    const double share = world % 2 == 0 ? 0.002 : 0.05;
    for (int cell = 0; cell < grid.width * grid.height; ++cell) {
      grid.log_odds.push_back(chance(share, random) ? 3.5F : -3.5F);
    }
    const FreeSpace space = free_space(grid, {.island_max_m = 0});
    const SightLines sight_lines(space);
    for (int line = 0; line < 300; ++line) {
      const Point2 from = grid.frame_from_grid * Point2{between(0, 90, random) * grid.resolution_m,
                                                        between(0, 70, random) * grid.resolution_m};
      const Point2 along = unit_vector(between(0, 2 * std::numbers::pi, random));
      const SightLines::Line looked = sight_lines.line(from, along);
      CAPTURE(world, line);
      REQUIRE(sight_lines.cell_at(from) == grid.cell_at(from));
      REQUIRE(looked.cell_at(7) == grid.cell_at(from + (7 * sight_lines.step_m()) * along));
      int steps = 0;
      while (steps < 60 && space.is_free(looked.cell_at(steps))) ++steps;
      REQUIRE(sight_lines.free_steps(from, along, 60) == steps);
    }
  }
}

}  // namespace asterism
