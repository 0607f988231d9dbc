#include "drawing/plane_drawing.hpp"

#include <algorithm>

#include "drawing/crossings.hpp"
#include "engine/tree/map_tree.hpp"
#include "planarity/euler.hpp"
#include "simulation/corridor_world.hpp"
#include "simulation/grid_world.hpp"
#include "simulation/walk.hpp"
#include "tests/drawing/drawing_check.hpp"
#include "tests/planarity/random_map.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/known_traces.hpp"

using namespace asterism;

namespace {
void check_drawing(const TopologicalMap& map) {
  const MapDrawing drawing = draw(map);
  CHECK(drawing.without_crossings == is_planar(map));
  CHECK(fault_of_stars(map, drawing) == "");
  if (drawing.without_crossings)
    CHECK(fault_of_crossings(map, drawing) == "");
  else
    CHECK(fault_of_crossings(map, drawing) != "");
}

bool has_bends(const MapDrawing& drawing) {
  return std::any_of(drawing.segments.begin(), drawing.segments.end(),
                     [](const auto& line) { return line.size() > 2; });
}

TopologicalMap true_map(const World& world, RandomEngine& engine) {
  const Walk seen = walk(world, {.travels = 120}, engine);
  return make_map(seen.trace, seen.truth);
}
}  // namespace

TEST_CASE("every map of the known traces is drawn, without crossings iff planar",
          "[planarity][property]") {
  std::size_t planar = 0, other = 0;
  for (const KnownTrace& known : known_traces()) {
    MapTree tree;
    tree.extend(known.trace.visits);
    tree.for_each([&](HypothesisId, std::span<const Arrival> arrivals) {
      const TopologicalMap map = make_map(known.trace, arrivals);
      is_planar(map) ? ++planar : ++other;
      check_drawing(map);
    });
  }
  CHECK(planar == 399);  // the planar column of expected.json, added up
  CHECK(other == 311);
}

//  7 -- 0 -- 1
//  |    |    |      the place numbers of a route that drove round the ring first
//  6 -- 8 -- 2
//  |    |    |
//  5 -- 4 -- 3
TEST_CASE("a ring with a cross inside is drawn as a square with a cross", "[planarity]") {
  for (const KnownTrace& known : known_traces()) {
    if (known.trace.name != "aces-stubs") continue;
    MapTree tree(MapTree::Options{.theory = {.planar = true}});
    tree.extend(known.trace.visits);
    REQUIRE(tree.minimal().size() == 1);
    const MapDrawing drawing = draw(tree.map(tree.minimal().front()));
    CHECK_FALSE(has_bends(drawing));
    const double side = drawing.places[1].x - drawing.places[0].x;
    CHECK(side > 0.5);
    const MapDrawing::Point middle = drawing.places[8];
    const int columns[] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
    const int rows[] = {1, 1, 0, -1, -1, -1, 0, 1, 0};
    for (std::size_t p = 0; p < 9; ++p) {
      CHECK(drawing.places[p].x == middle.x + columns[p] * side);
      CHECK(drawing.places[p].y == middle.y + rows[p] * side);
    }
  }
}

TEST_CASE("a grid is drawn as a grid: no segment bends", "[planarity][property]") {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    RandomEngine engine(seed);
    const TopologicalMap map = true_map(grid_world({.width = 5, .height = 5}, engine), engine);
    CAPTURE(seed);
    check_drawing(map);
    CHECK_FALSE(has_bends(draw(map)));
  }
}

TEST_CASE("straight corridors at all angles are drawn without crossings", "[planarity][property]") {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    RandomEngine engine(seed);
    CAPTURE(seed);
    check_drawing(true_map(corridor_world({}, engine), engine));
  }
}

TEST_CASE("stars of every kind are drawn, without crossings iff planar", "[planarity][property]") {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    CAPTURE(seed);
    check_drawing(random_map(seed, {.most_places = 3 + seed % 16,
                                    .most_local_paths = 2 + seed % 4,
                                    .is_planar = seed % 5 != 0}));
  }
}

TEST_CASE("a place alone shows its arms", "[planarity]") {
  TopologicalMap map;
  map.places.push_back(
      {Star::parse(GENERATE("a+1 a-0", "a+1 b+1 a-1 b-0", "a+1 b+1 c+1 a-1 b-1 c-1")), VisitId(0)});
  check_drawing(map);
}

TEST_CASE("a hundred places with up to six arms are drawn", "[planarity]") {
  const TopologicalMap map = random_map(2, {.most_places = 100, .most_local_paths = 3});
  REQUIRE(map.places.size() == 100);
  const MapDrawing drawing = draw(map);
  CHECK(drawing.without_crossings);
  CHECK(fault_of_stars(map, drawing) == "");
}

TEST_CASE("the same map is drawn alike each time", "[planarity]") {
  const TopologicalMap map = random_map(3, {.most_places = 40, .most_local_paths = 3});
  const MapDrawing one = draw(map), other = draw(map);
  for (std::size_t p = 0; p < map.places.size(); ++p) {
    CHECK(one.places[p].x == other.places[p].x);
    CHECK(one.places[p].y == other.places[p].y);
  }
}

TEST_CASE("the check of a drawing sees a place moved onto another's segment", "[planarity]") {
  RandomEngine engine(5);
  const TopologicalMap map = true_map(grid_world({.missing = 0}, engine), engine);
  MapDrawing drawing = draw(map);
  REQUIRE(is_plane(map, drawing));
  std::swap(drawing.arms[0][0], drawing.arms[0][1]);
  CHECK_FALSE(is_plane(map, drawing));
  drawing = draw(map);
  drawing.segments.front().insert(drawing.segments.front().begin() + 1, drawing.places.back());
  CHECK_FALSE(is_plane(map, drawing));
}
