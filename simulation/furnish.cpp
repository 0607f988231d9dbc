#include "simulation/furnish.hpp"

#include <algorithm>

namespace asterism {
namespace {

constexpr double door_m = 0.9;
constexpr double max_depth_m = 0.7;  ///< of what stands at a wall

/// One wall of a stretch, seen from its middle line: x along it, y towards the wall.
class Side {
 public:
  Side(const Stretch& stretch, bool is_left) : half_width_m_(stretch.width_m / 2) {
    origin_ = stretch.from;
    along_ = unit_towards(stretch.from, stretch.to);
    outwards_ = is_left ? left_of(along_) : -1 * left_of(along_);
  }

  Point2 point(double along_m, double beyond_wall_m) const {
    return origin_ + along_m * along_ + (half_width_m_ + beyond_wall_m) * outwards_;
  }
  /// From x = first_m to last_m, and in depth from y = near_m to far_m, 0 being the wall.
  Polygon box(double first_m, double last_m, double near_m, double far_m) const {
    const double middle_m = (near_m + far_m) / 2;
    return rectangle(point(first_m, middle_m), point(last_m, middle_m), far_m - near_m);
  }

 private:
  Point2 origin_;
  Point2 along_;
  Point2 outwards_;
  double half_width_m_;
};

bool is_solid(const Polygon& part, const FloorPlan& plan) {
  return std::none_of(plan.rooms.begin(), plan.rooms.end(),
                      [&](const Polygon& room) { return overlap(part, room); });
}

void add_clutter(const Side& side, double at_m, double depth_m, FloorPlan& plan,
                 RandomEngine& engine) {
  const double kind = uniform(engine);
  if (kind < 0.5) {
    const double deep_m = between(0.15, depth_m, engine);
    plan.furniture.push_back(side.box(at_m, at_m + between(0.4, 1.2, engine), -deep_m, 0.05));
  } else {
    // A bin stands at the wall, a pillar is half in it.
    const double radius_m = std::min(between(0.12, 0.25, engine), depth_m / 2);
    const double middle_m = kind < 0.8 ? -radius_m : 0;
    plan.furniture.push_back(disc(side.point(at_m + radius_m, middle_m), radius_m, 12));
  }
}

/// A room behind an open door, and its leaf.
void add_room(const Side& side, double at_m, FloorPlan& plan, RandomEngine& engine) {
  constexpr double wall_m = 0.15;
  const double left_m = between(0.3, 2, engine);
  const double right_m = between(0.3, 2, engine);
  const double depth_m = between(2, 3.5, engine);
  Polygon room = side.box(at_m - left_m, at_m + door_m + right_m, wall_m, wall_m + depth_m);
  const Polygon with_walls = side.box(at_m - left_m - wall_m, at_m + door_m + right_m + wall_m,
                                      0.01, depth_m + 2 * wall_m);
  if (!is_solid(with_walls, plan)) return;
  plan.rooms.push_back(std::move(room));
  plan.rooms.push_back(side.box(at_m, at_m + door_m, -0.1, wall_m + 0.1));
  plan.furniture.push_back(side.box(at_m, at_m + 0.04, wall_m + 0.02, wall_m + door_m));
}

void add_door(const Side& side, double at_m, const FurnishOptions& options, FloorPlan& plan,
              RandomEngine& engine) {
  const double kind = uniform(engine);
  if (kind < options.open_doors) {
    add_room(side, at_m, plan, engine);
    return;
  }
  const double niche_m = between(0.08, 0.3, engine);
  if (!is_solid(side.box(at_m, at_m + door_m, 0.01, niche_m + 0.1), plan)) return;
  plan.rooms.push_back(side.box(at_m, at_m + door_m, -0.1, niche_m));
  if (kind < options.open_doors + options.glass_doors)
    plan.panes.push_back({side.point(at_m, 0), side.point(at_m + door_m, 0)});
}

}  // namespace

void furnish(const Stretch& stretch, const FurnishOptions& options, FloorPlan& plan,
             RandomEngine& engine) {
  constexpr double longest_m = 1.3;
  // The middle line stays clear too.
  const double depth_m =
      std::min({max_depth_m, stretch.width_m - options.min_clear_m, stretch.width_m / 2 - 0.2});
  const double length_m = norm(stretch.to - stretch.from);
  double at_m = between(0, options.max_gap_m, engine);
  for (; at_m + longest_m < length_m;
       at_m += longest_m + between(options.min_gap_m, options.max_gap_m, engine)) {
    const Side side(stretch, chance(0.5, engine));
    if (!chance(options.clutter, engine))
      add_door(side, at_m, options, plan, engine);
    else if (depth_m >= 0.2)
      add_clutter(side, at_m, depth_m, plan, engine);
  }
}

}  // namespace asterism
