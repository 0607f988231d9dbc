#include "drawing/jogs.hpp"

#include <algorithm>
#include <cstdlib>

namespace asterism {
namespace {

using Edge = PlaneGraph::Edge;

constexpr long tolerated = 2;  ///< grid steps, about one vertex of a rim further out

long dot(GridPoint a, GridPoint b) { return a.x * b.x + a.y * b.y; }

long sign(long value) { return (value > 0) - (value < 0); }

/// How far the arm's vertex lies to the left of where it would be on a small cage.
long displacement(const PlaneGraph& graph, const std::vector<GridPoint>& layout, std::size_t arm) {
  const GridPoint from = layout[graph[arm].origin];
  const GridPoint to = layout[graph.target(arm)];
  const GridPoint ahead{sign(to.x - from.x), sign(to.y - from.y)};
  const GridPoint left{-ahead.y, ahead.x};
  long least = dot(from, left), most = least;  // of the cage
  long before = 0, count = 0;                  // vertices on the arm's side of it
  for (const std::size_t rim : graph.face(graph[arm ^ 1].next ^ 1)) {
    const GridPoint at = layout[graph[rim].origin];
    least = std::min(least, dot(at, left));
    most = std::max(most, dot(at, left));
    if (dot(at, ahead) != dot(from, ahead)) continue;
    ++count;
    if (dot(at, left) < dot(from, left)) ++before;
  }
  return dot(from, left) - (least + most) / 2 - cage_side * (2 * before - count + 1) / 2;
}

}  // namespace

PlaneGraph with_jogs(const PlaneGraph& graph, const std::vector<GridPoint>& layout) {
  PlaneGraph jogged = graph;
  for (std::size_t d = 0; d < graph.dart_count(); ++d) {
    const bool leaves_a_cage = graph[d].arm && graph.edge(graph[d ^ 1].next) == Edge::cage;
    if (!leaves_a_cage || graph.edge(d) != Edge::segment) continue;
    const long left = displacement(graph, layout, d);
    if (std::abs(left) <= tolerated) continue;
    const int turn = left > 0 ? 1 : -1;
    const std::size_t across = jogged.split(d);
    const std::size_t onward = jogged.split(across);
    jogged.set_turn(d, turn);
    jogged.set_turn(across ^ 1, -turn);
    jogged.set_turn(across, -turn);
    jogged.set_turn(onward ^ 1, turn);
  }
  return jogged;
}

}  // namespace asterism
