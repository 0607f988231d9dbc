#include "perception/pruning.hpp"

#include <cmath>
#include <numbers>

#include "perception/gateways.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

// Rooms and corridors cut out of a block of wall, 30 m by 30 m, its middle at the origin.
class Plan {
 public:
  Plan() : grid_{.width = 300, .height = 300, .frame_from_grid = {-15, -15, 0}} {
    grid_.log_odds.assign(300 * 300, 3.5F);
  }
  Plan& cut(Point2 low, Point2 high) { return fill(low, high, -3.5F); }
  Plan& wall(Point2 low, Point2 high) { return fill(low, high, 3.5F); }
  Plan& unseen(Point2 low, Point2 high) { return fill(low, high, 0); }
  const Grid& grid() const { return grid_; }

 private:
  Plan& fill(Point2 low, Point2 high, float log_odds) {
    for (int row = 0; row < grid_.height; ++row) {
      for (int column = 0; column < grid_.width; ++column) {
        const Point2 at = grid_.centre({column, row});
        if (at.x_m > low.x_m && at.y_m > low.y_m && at.x_m < high.x_m && at.y_m < high.y_m) {
          grid_.log_odds[grid_.index({column, row})] = log_odds;
        }
      }
    }
    return *this;
  }
  Grid grid_;
};

// A ring corridor round a block this wide, whose south side goes on to the unknown in the west.
Plan ring(double block_m) {
  const double out_m = block_m / 2 + 2;
  return Plan()
      .cut({-out_m, -out_m}, {out_m, out_m})
      .wall({-block_m / 2, -block_m / 2}, {block_m / 2, block_m / 2})
      .cut({-14, -out_m}, {-out_m, -out_m + 2})
      .unseen({-15, -out_m}, {-14, -out_m + 2});
}

Skeleton skeleton_of(const Plan& plan, Point2 robot, std::span<const Point2> driven = {}) {
  const FreeSpace space = free_space(plan.grid());
  return skeleton(space, plan.grid().cell_at(robot), {}, driven);
}

std::size_t gateways_at(const Plan& plan, Point2 robot, std::span<const Point2> driven = {}) {
  const FreeSpace space = free_space(plan.grid());
  const Skeleton lines = skeleton(space, plan.grid().cell_at(robot), {}, driven);
  const auto found = neighbourhood(space, lines, robot);
  return found ? found->gateways.size() : 0;
}

bool comes_near(const Skeleton& skeleton, const Grid& grid, Point2 point) {
  for (std::size_t i = 0; i < skeleton.points.size(); ++i) {
    if (skeleton.is_critical(i) && norm(grid.centre(skeleton.points[i].cell) - point) < 1.5) {
      return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("both ways round a long loop are kept", "[perception]") {
  const Plan plan = ring(10);
  const Skeleton found = skeleton_of(plan, {-6, -6});
  REQUIRE(found.exits.size() == 1);
  for (const Point2 side : {Point2{6, 0}, Point2{0, 6}, Point2{-6, 0}, Point2{0, -6}}) {
    CAPTURE(side.x_m, side.y_m);
    CHECK(comes_near(found, plan.grid(), side));
  }
  CHECK(gateways_at(plan, {-6, -6}) == 3);
  CHECK(gateways_at(plan, {6, 6}) == 2);
}

TEST_CASE("a short loop leads round furniture: one way is enough", "[perception]") {
  // A hall with a table of 2 m in it, and corridors out of it to the west and to the east.
  const Plan plan = Plan()
                        .cut({-4, -4}, {4, 4})
                        .wall({-1, -1}, {1, 1})
                        .cut({-14, -1}, {-4, 1})
                        .cut({4, -1}, {14, 1})
                        .unseen({-15, -1}, {-14, 1})
                        .unseen({14, -1}, {15, 1});
  const Skeleton found = skeleton_of(plan, {-2, 0});
  REQUIRE(found.exits.size() == 2);
  CHECK(comes_near(found, plan.grid(), {0, 2.5}) != comes_near(found, plan.grid(), {0, -2.5}));
}

TEST_CASE("a ring that is seen whole has its corners", "[perception]") {
  const Plan plan = Plan().cut({-7, -7}, {7, 7}).wall({-5, -5}, {5, 5});
  CHECK(skeleton_of(plan, {-6, -6}).exits.empty());
  CHECK(gateways_at(plan, {-6, -6}) == 2);
}

TEST_CASE("a stub is no way out, a hallway to a dead end is one", "[perception]") {
  // A corridor from west to east, and a blind one to the north of it.
  const auto with_blind = [](double length_m) {
    return Plan()
        .cut({-14, -1}, {14, 1})
        .unseen({-15, -1}, {-14, 1})
        .unseen({14, -1}, {15, 1})
        .cut({-1, 1}, {1, 1 + length_m});
  };
  CHECK(gateways_at(with_blind(5), {0, 0}) == 2);
  CHECK(gateways_at(with_blind(11), {0, 0}) == 3);
  // Where the robot drove a stub is a way.
  const std::vector<Point2> driven{{0, 0}, {0, 2}, {0, 4}};
  CHECK(gateways_at(with_blind(5), {0, 0}, driven) == 3);
  CHECK(gateways_at(with_blind(5), {0, 4}, driven) == 1);
  // A look into it is not.
  const std::vector<Point2> looked{{0, 0}, {0, 0.8}};
  CHECK(gateways_at(with_blind(5), {0, 0}, looked) == 2);
}
