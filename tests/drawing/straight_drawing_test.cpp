#include "drawing/straight_drawing.hpp"

#include <cmath>
#include <set>

#include "core/random.hpp"
#include "planarity/boyer_myrvold.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

using Edges = std::vector<std::pair<std::size_t, std::size_t>>;
using Point = MapDrawing::Point;

constexpr double rounding = 1e-9;  // of products of coordinates of some tens

/// Twice the area to the left of a, b, c.
double area(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool is_between(Point a, Point b, Point c) {
  return std::abs(area(a, b, c)) < rounding &&
         (c.x - a.x) * (c.x - b.x) + (c.y - a.y) * (c.y - b.y) < -rounding;
}

bool cross(Point a, Point b, Point c, Point d) {
  return area(a, b, c) * area(a, b, d) < -rounding && area(c, d, a) * area(c, d, b) < -rounding;
}

/// No two vertices at one point, none on an edge, no two edges across each other.
bool is_clean(const StraightDrawing& drawing, const Edges& edges) {
  const auto& at = drawing.vertices;
  for (std::size_t v = 0; v < at.size(); ++v)
    for (std::size_t w = 0; w < v; ++w)
      if (std::hypot(at[v].x - at[w].x, at[v].y - at[w].y) < 0.5) return false;
  for (const auto& [a, b] : edges) {
    for (const Point& vertex : at)
      if (is_between(at[a], at[b], vertex)) return false;
    for (const auto& [c, d] : edges)
      if (cross(at[a], at[b], at[c], at[d])) return false;
  }
  return true;
}

Edges random_connected(std::size_t vertices, std::size_t more, RandomEngine& engine) {
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (std::size_t v = 1; v < vertices; ++v) edges.emplace(below(v, engine), v);
  for (std::size_t i = 0; i < more; ++i) {
    const std::size_t a = below(vertices, engine);
    const std::size_t b = below(vertices, engine);
    if (a != b) edges.insert(std::minmax(a, b));
  }
  return {edges.begin(), edges.end()};
}

}  // namespace

TEST_CASE("a straight drawing is without crossings iff the graph is planar",
          "[planarity][property]") {
  std::size_t planar = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    RandomEngine engine(seed);
    const std::size_t vertices = 2 + below(9, engine);
    const Edges edges = random_connected(vertices, below(2 * vertices, engine), engine);
    INFO("seed " << seed);
    const StraightDrawing drawing = draw_straight(vertices, edges);
    REQUIRE(drawing.vertices.size() == vertices);
    CHECK(drawing.without_crossings == is_planar_graph(vertices, edges));
    CHECK(is_clean(drawing, edges) == drawing.without_crossings);
    planar += drawing.without_crossings ? 1U : 0U;
  }
  CHECK(planar > 100);
  CHECK(planar < 390);
}

TEST_CASE("a ring is drawn as one", "[planarity]") {
  const StraightDrawing drawing = draw_straight(4, Edges{{0, 1}, {1, 2}, {2, 3}, {0, 3}, {1, 0}});
  for (const Point& vertex : drawing.vertices)
    CHECK(std::hypot(vertex.x, vertex.y) == Approx(std::sqrt(0.5)));
  CHECK(draw_straight(1, Edges{}).vertices.size() == 1);
  CHECK(draw_straight(1, Edges{{0, 0}}).without_crossings);
}
