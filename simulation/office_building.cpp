#include "simulation/office_building.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>

#include "simulation/grid_world.hpp"

namespace asterism {
namespace {

constexpr double min_corridor_m = 8;
constexpr double min_hall_radius_m = 2.9;
constexpr double max_hall_radius_m = 4;
constexpr double place_radius_m = 2.5;

/// The world of a grid, its lines moved apart to pitches of their own.
World uneven_world(const OfficeOptions& options, RandomEngine& engine) {
  World world = grid_world({.width = options.columns,
                            .height = options.rows,
                            .pitch_m = 1,
                            .missing = options.missing,
                            .stubs = 0,
                            .min_places = options.min_places},
                           engine);
  const auto lines = [&](std::size_t count) {
    std::vector<double> at_m{0};
    while (at_m.size() < count)
      at_m.push_back(at_m.back() + between(options.min_pitch_m, options.max_pitch_m, engine));
    return at_m;
  };
  const std::vector<double> x_m = lines(options.columns);
  const std::vector<double> y_m = lines(options.rows);
  for (World::Place& place : world.places)
    place.position = {x_m[static_cast<std::size_t>(place.position.x_m + 0.5)],
                      -y_m[static_cast<std::size_t>(-place.position.y_m + 0.5)]};
  return world;
}

/// Builds one office block; each step needs those before it.
class Builder {
 public:
  Builder(World world, const OfficeOptions& options, RandomEngine& engine)
      : world_(std::move(world)), options_(options), engine_(engine) {}

  Building build() {
    draw_widths();
    draw_halls();
    for (const auto& [gateway, reached] : world_.segments)
      if (gateway < reached) add_corridor(gateway, reached);
    for (std::size_t place = 0; place < world_.places.size(); ++place) add_ends(PlaceId(place));
    for (const Stretch& stretch : stretches_) furnish(stretch, options_.furnish, plan_, engine_);
    Building result{"office", world_, {}, walls_of(plan_)};
    for (const double radius_m : hall_radius_m_)
      result.place_radius_m.push_back(std::max(place_radius_m, radius_m + 0.2));
    return result;
  }

 private:
  const World::Place& place(PlaceId id) const { return world_.places[id.index()]; }

  void draw_widths() {
    for (const auto& [gateway, reached] : world_.segments) {
      if (width_m_.contains(gateway)) continue;
      const double width_m = between(options_.min_width_m, options_.max_width_m, engine_);
      give_width(gateway, width_m);
      give_width(reached, width_m);
    }
  }

  /// To the corridor out of a gateway, all the way straight on.
  void give_width(PlaceArm gateway, double width_m) {
    for (auto next = world_.segments.find(gateway); next != world_.segments.end();) {
      width_m_[next->first] = width_m_[next->second] = width_m;
      const PlaceArm reached = next->second;
      next = world_.segments.find({reached.place, place(reached.place).star.opposite(reached.arm)});
    }
  }

  /// Half the width of the widest corridor at a place that lies across `arm`, or of its own.
  double mouth_m(PlaceArm arm) const {
    const Star& star = place(arm.place).star;
    double result = 0;
    for (std::size_t other = 0; other < star.size(); ++other) {
      const bool is_across = other != arm.arm && other != star.opposite(arm.arm);
      const auto width_m = width_m_.find({arm.place, other});
      if (is_across && width_m != width_m_.end()) result = std::max(result, width_m->second / 2);
    }
    const auto own = width_m_.find(arm);
    return result > 0 || own == width_m_.end() ? result : own->second / 2;
  }

  double extent_m(PlaceArm arm) const {
    return std::max(mouth_m(arm), hall_radius_m_[arm.place.index()]);
  }

  double distance_m(PlaceId a, PlaceId b) const {
    return norm(place(b).position - place(a).position);
  }

  void draw_halls() {
    hall_radius_m_.assign(world_.places.size(), 0);
    for (std::size_t i = 0; i < world_.places.size(); ++i) {
      const double radius_m = between(min_hall_radius_m, max_hall_radius_m, engine_);
      if (!chance(options_.halls, engine_)) continue;
      std::size_t corridors = 0;
      bool has_room = true;
      for (std::size_t arm = 0; arm < world_.places[i].star.size(); ++arm) {
        const auto segment = world_.segments.find({PlaceId(i), arm});
        if (segment == world_.segments.end()) continue;
        ++corridors;
        const double left_m =
            distance_m(PlaceId(i), segment->second.place) - radius_m - extent_m(segment->second);
        has_room = has_room && left_m >= min_corridor_m;
      }
      if (corridors >= 3 && has_room) hall_radius_m_[i] = radius_m;
    }
  }

  void add_corridor(PlaceArm gateway, PlaceArm reached) {
    const Point2 from = place(gateway.place).position;
    const Point2 to = place(reached.place).position;
    const Point2 along = unit_towards(from, to);
    const double width_m = width_m_.at(gateway);
    plan_.rooms.push_back(
        rectangle(from - mouth_m(gateway) * along, to + mouth_m(reached) * along, width_m));
    constexpr double margin_m = 0.8;
    stretches_.push_back({from + (extent_m(gateway) + margin_m) * along,
                          to - (extent_m(reached) + margin_m) * along, width_m});
  }

  /// A place's hall, and the blind stubs where a corridor might have gone on.
  void add_ends(PlaceId id) {
    const auto& [position, star] = place(id);
    const double radius_m = hall_radius_m_[id.index()];
    if (radius_m > 0) plan_.rooms.push_back(disc(position, radius_m));
    const std::vector<double> headings_rad = arm_headings_rad(world_, id);
    for (std::size_t arm = 0; arm < star.size(); ++arm) {
      const bool is_dead_end = star.size() == 2;
      if (star.has_gateway(arm) || is_dead_end || !chance(options_.blind_stubs, engine_)) continue;
      const double length_m = std::max(radius_m, mouth_m({id, arm})) + between(3, 5.5, engine_);
      const double width_m = std::min(width_m_.at({id, star.opposite(arm)}),
                                      between(options_.min_width_m, 2.2, engine_));
      plan_.rooms.push_back(
          rectangle(position, position + length_m * unit_vector(headings_rad[arm]), width_m));
    }
  }

  World world_;
  const OfficeOptions& options_;
  RandomEngine& engine_;
  FloorPlan plan_;
  std::map<PlaceArm, double> width_m_;  ///< of the corridor out of each gateway
  std::vector<double> hall_radius_m_;   ///< [place]: 0 where it is none
  std::vector<Stretch> stretches_;
};

}  // namespace

Building office_building(const OfficeOptions& options, RandomEngine& engine) {
  if (options.min_pitch_m - options.max_width_m < min_corridor_m)
    throw std::invalid_argument(
        "found a pitch that leaves less than 8 m of corridor; expected more");
  return Builder(uneven_world(options, engine), options, engine).build();
}

}  // namespace asterism
