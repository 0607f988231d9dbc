#include "simulation/people.hpp"

#include <iterator>

namespace asterism {
namespace {

constexpr double near_m = 0.9;  ///< to the robot; nobody comes nearer
constexpr double far_m = 15;    ///< from the robot; nobody goes farther

}  // namespace

People::People(const World& world, std::size_t count, RandomEngine engine)
    : world_(&world), engine_(engine), count_(count) {}

void People::walk(double seconds, Point2 robot) {
  while (walkers_.size() < count_) walkers_.push_back(come(robot));
  positions_.clear();
  for (Walker& walker : walkers_) {
    step(walker, seconds, robot);
    positions_.push_back({position(walker)});
  }
}

double People::length_m(PlaceArm gateway) const {
  const PlaceId reached = world_->segments.at(gateway).place;
  return norm(world_->places[reached.index()].position -
              world_->places[gateway.place.index()].position);
}

Point2 People::position(const Walker& walker) const {
  const Point2 from = world_->places[walker.gateway.place.index()].position;
  const PlaceId reached = world_->segments.at(walker.gateway).place;
  const Point2 along = unit_towards(from, world_->places[reached.index()].position);
  return from + walker.gone_m * along + walker.left_m * left_of(along);
}

People::Walker People::turned_round(const Walker& walker) const {
  return {world_->segments.at(walker.gateway), length_m(walker.gateway) - walker.gone_m,
          -walker.left_m, walker.speed_m_per_s};
}

/// Someone out of a door: not right before the robot, nor farther away than can be helped.
People::Walker People::come(Point2 robot) {
  constexpr double too_near_m = 3;
  constexpr int tries = 60;
  std::optional<Walker> best;
  double best_m = 0;
  for (int i = 0; i < tries; ++i) {
    const auto segment =
        std::next(world_->segments.begin(),
                  static_cast<std::ptrdiff_t>(below(world_->segments.size(), engine_)));
    const double gone_m = between(0, length_m(segment->first), engine_);
    const double left_m = between(-0.4, 0.4, engine_);
    const Walker walker{segment->first, gone_m, left_m, between(0.7, 1.4, engine_)};
    const double away_m = norm(position(walker) - robot);
    if (away_m < too_near_m) continue;
    if (!best || away_m < best_m) {
      best = walker;
      best_m = away_m;
    }
    if (best_m < far_m / 2) break;
  }
  return best.value();
}

void People::step(Walker& walker, double seconds, Point2 robot) {
  const auto is_near = [&](const Walker& one) { return norm(position(one) - robot) < near_m; };
  walker.gone_m += walker.speed_m_per_s * seconds;
  if (walker.gone_m > length_m(walker.gateway)) {
    const PlaceArm reached = world_->segments.at(walker.gateway);
    const std::size_t arms = world_->places[reached.place.index()].star.size();
    PlaceArm on{reached.place, below(arms, engine_)};
    while (!world_->segments.contains(on)) on.arm = (on.arm + 1) % arms;
    walker.gateway = on;
    walker.gone_m = 0;
  }
  if (is_near(walker)) {
    walker = turned_round(walker);
    walker.gone_m += 2 * walker.speed_m_per_s * seconds;
  }
  const bool is_gone = norm(position(walker) - robot) > far_m;
  if (is_near(walker) || is_gone) walker = come(robot);
}

}  // namespace asterism
