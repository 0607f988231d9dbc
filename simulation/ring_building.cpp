#include "simulation/ring_building.hpp"

#include <array>

#include "simulation/furnish.hpp"

namespace asterism {
namespace {

constexpr double west_m = -20, middle_m = 0, east_m = 24;
constexpr double north_m = 0, centre_m = -18, south_m = -39;

constexpr double ring_width_m = 1.9;
constexpr double lobby_width_m = 3.4;
constexpr double lobby_depth_m = 8;
constexpr double beyond_a_local_map_m = 21;
constexpr double hall_radius_m = 4;
constexpr double neck_width_m = 2.2;
constexpr double neck_m = 2;  ///< its length

const std::vector<Point2> points{{middle_m, north_m}, {east_m, north_m},   {east_m, centre_m},
                                 {east_m, south_m},   {middle_m, south_m}, {west_m, south_m},
                                 {west_m, centre_m},  {west_m, north_m},   {middle_m, centre_m}};
enum Point : std::size_t { n, ne, e, se, s, sw, w, nw, c };

/// A corridor between two neighbouring points and how far from them its things begin.
struct Piece {
  Point from;
  Point to;
  double width_m;
};
constexpr double vertical_width_m = 3.4;
constexpr double horizontal_width_m = 2.6;
constexpr std::array pieces{Piece{nw, n, ring_width_m},      Piece{n, ne, ring_width_m},
                            Piece{sw, s, ring_width_m},      Piece{s, se, ring_width_m},
                            Piece{sw, w, ring_width_m},      Piece{w, nw, ring_width_m},
                            Piece{se, e, ring_width_m},      Piece{e, ne, ring_width_m},
                            Piece{s, c, vertical_width_m},   Piece{c, n, vertical_width_m},
                            Piece{w, c, horizontal_width_m}, Piece{c, e, horizontal_width_m}};

World ring_world() {
  return make_world(points, {{"top", {1, 0}, {nw, n, ne}, true, true},
                             {"across", {1, 0}, {w, c, e}},
                             {"bottom", {1, 0}, {sw, s, se}},
                             {"left", {0, 1}, {sw, w, nw}},
                             {"up", {0, 1}, {s, c, n}},
                             {"right", {0, 1}, {se, e, ne}}});
}

/// How much of a corridor lies in the place at its end.
double extent_m(Point point) {
  if (point == c) return hall_radius_m + neck_m;
  return point == n || point == s ? lobby_width_m / 2 : ring_width_m / 2;
}

/// A corridor, with what stands in it; into the hall it comes through a neck.
Stretch add_corridor(const Piece& piece, FloorPlan& plan) {
  const Point2 from = points[piece.from];
  const Point2 to = points[piece.to];
  const Point2 along = unit_towards(from, to);
  const bool is_from_hall = piece.from == c;
  const bool is_to_hall = piece.to == c;
  const Point2 first =
      is_from_hall ? from + extent_m(c) * along : from - (ring_width_m / 2) * along;
  const Point2 last = is_to_hall ? to - extent_m(c) * along : to + (ring_width_m / 2) * along;
  plan.rooms.push_back(rectangle(first, last, piece.width_m));
  if (is_from_hall || is_to_hall)
    plan.rooms.push_back(rectangle(is_from_hall ? from : last - 0.2 * along,
                                   is_from_hall ? first + 0.2 * along : to, neck_width_m));
  constexpr double margin_m = 0.8;
  return {from + (extent_m(piece.from) + margin_m) * along,
          to - (extent_m(piece.to) + margin_m) * along, piece.width_m};
}

/// An opening out of a place, from its middle.
void add_opening(Point2 from, Point2 way, double width_m, FloorPlan& plan) {
  plan.rooms.push_back(rectangle(from, from + way, width_m));
}

void add_side_openings(FloorPlan& plan) {
  const double to_end_m = ring_width_m / 2 + lobby_depth_m;
  add_opening(points[n], {0, to_end_m}, lobby_width_m, plan);
  add_opening(points[s], {0, -to_end_m}, lobby_width_m, plan);
  add_opening(points[ne], {beyond_a_local_map_m, 0}, ring_width_m, plan);
  add_opening(points[nw], {-beyond_a_local_map_m, 0}, ring_width_m, plan);
  const Point2 alcove = points[sw] + Point2{0, 0.4};
  add_opening(alcove, {-4.6, 0}, 2.7, plan);
}

}  // namespace

Building ring_building(RandomEngine& engine) {
  FloorPlan plan;
  std::vector<Stretch> stretches;
  for (const Piece& piece : pieces) stretches.push_back(add_corridor(piece, plan));
  plan.rooms.push_back(disc(points[c], hall_radius_m, 64));
  add_side_openings(plan);
  for (const Stretch& stretch : stretches)
    furnish(stretch, {.clutter = 0.35, .open_doors = 0.4}, plan, engine);
  return {"aces-like",
          ring_world(),
          {2.5, 2.5, 2.5, 2.5, 2.5, 2.5, 2.5, 2.5, hall_radius_m + 0.2},
          walls_of(plan)};
}

Route ring_route(const World& ring) {
  std::vector<PlaceId> places;
  for (const Point point : {n, ne, e, se, s, sw, w, nw, n, c, s, c, w, c, e})
    places.emplace_back(point);
  return route_through(ring, places);
}

}  // namespace asterism
