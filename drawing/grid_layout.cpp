#include "drawing/grid_layout.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "drawing/min_cost_flow.hpp"
#include "drawing/rectangles.hpp"

namespace asterism {
namespace {

using Edge = PlaneGraph::Edge;

constexpr long place_distance = 3;  ///< least length of a segment without bends: stubs fit between
constexpr int rounds = 6;           ///< of moving columns and rows; most layouts settle in three

constexpr long cage_pull = 8;  ///< cages are to be small: they stand for a place

/// position[to] - position[from] >= least
struct Gap {
  std::size_t from;
  std::size_t to;
  long least;
  long pull = 1;  ///< what it costs to be longer
};

/// The smallest positions that keep the gaps.
std::vector<long> packed(std::size_t count, const std::vector<Gap>& gaps) {
  std::vector<long> position(count, 0);
  for (bool has_moved = true; has_moved;) {
    has_moved = false;
    for (const auto& [from, to, least, pull] : gaps) {
      if (position[to] >= position[from] + least) continue;
      position[to] = position[from] + least;
      has_moved = true;
    }
  }
  return position;
}

/// Positions that keep the gaps `least` and make the lengths of `edges` beyond their least as short
/// and as even as possible: each further unit of an edge costs more, as `dearer_at` says.
///
/// The linear program  minimise Σ cost(x_to - x_from),  x_to - x_from >= least  is the dual of a
/// cheapest flow in which each gap is an unlimited arc of cost -least, and each rise of an edge's
/// cost a backward arc of capacity `pull`; the positions are its potentials, negated.
std::vector<long> pulled_together(const std::vector<long>& start, const std::vector<Gap>& gaps,
                                  const std::vector<Gap>& edges) {
  constexpr long dearer_at[] = {0, 1, 2, 3, 5, 8, 12};
  const long unlimited = 1'000'000;
  std::vector<FlowArc> arcs;
  for (const auto& [from, to, least, pull] : gaps) arcs.push_back({from, to, unlimited, -least});
  for (const auto& [from, to, least, pull] : edges)
    for (const long extra : dearer_at) arcs.push_back({to, from, pull, least + extra});
  std::vector<long> potential;
  for (const long position : start) potential.push_back(-position);
  const Flow flow = cheapest_flow(arcs, std::vector<long>(start.size(), 0), potential);
  std::vector<long> result;
  for (const long value : flow.potential) result.push_back(-value);
  return result;
}

/// Along one axis, vertices joined across it share a line: a column where the axis is x.
class Axis {
 public:
  Axis(const PlaneGraph& graph, const std::vector<int>& direction, int axis)
      : line_(graph.vertex_count()) {
    std::iota(line_.begin(), line_.end(), std::size_t{0});
    for (std::size_t d = 0; d < graph.dart_count(); d += 2)
      if (direction[d] % 2 != axis) line_[root(graph[d].origin)] = root(graph.target(d));
    for (std::size_t v = 0; v < line_.size(); ++v) line_[v] = root(v);
    for (std::size_t d = 0; d < graph.dart_count(); ++d)
      if (direction[d] == axis)
        edges_.push_back({line_[graph[d].origin], line_[graph.target(d)], least_length(graph, d),
                          graph.edge(d) == Edge::cage ? cage_pull : 1});
  }

  std::size_t line(std::size_t vertex) const { return line_[vertex]; }
  const std::vector<Gap>& edges() const { return edges_; }

 private:
  static long least_length(const PlaneGraph& graph, std::size_t dart) {
    if (graph.edge(dart) == Edge::cage) return cage_side;
    return graph[dart].arm && graph[dart ^ 1].arm ? place_distance : 1;
  }

  std::size_t root(std::size_t vertex) const {
    while (line_[vertex] != vertex) vertex = line_[vertex];
    return vertex;
  }

  std::vector<std::size_t> line_;
  std::vector<Gap> edges_;
};

using Position = std::vector<long>;  ///< of lines

/// What keeps the drawing plane: where two lines are neighbours in a row, they stay in that order.
std::vector<Gap> neighbours(const PlaneGraph& graph, const Axis& axis, const Position& position,
                            const Axis& other, const Position& other_position) {
  struct Span {
    long low;
    long high;
  };
  std::map<std::size_t, Span> spans;  // of the lines
  for (std::size_t d = 0; d < graph.dart_count(); ++d) {
    const long at = other_position[other.line(graph[d].origin)];
    Span& span = spans.try_emplace(axis.line(graph[d].origin), Span{at, at}).first->second;
    span = {std::min(span.low, at), std::max(span.high, at)};
  }
  std::map<long, std::vector<std::pair<long, std::size_t>>> rows;
  for (const auto& [line, span] : spans)
    for (long row = span.low; row <= span.high; ++row) rows[row].emplace_back(position[line], line);
  std::map<std::pair<std::size_t, std::size_t>, long> least;
  for (auto& [row, lines] : rows) {
    std::sort(lines.begin(), lines.end());
    for (std::size_t i = 1; i < lines.size(); ++i)
      least[{lines[i - 1].second, lines[i].second}] = 1;
  }
  for (const auto& [from, to, length, pull] : axis.edges()) {
    long& wanted = least[{from, to}];
    wanted = std::max(wanted, length);
  }
  std::vector<Gap> gaps;
  for (const auto& [lines, length] : least) gaps.push_back({lines.first, lines.second, length});
  return gaps;
}

/// A plane start, wide enough for every least length.
std::vector<GridPoint> rectangular_layout(const PlaneGraph& graph, std::size_t north) {
  const PlaneGraph cut = cut_into_rectangles(graph);
  const std::vector<int> direction = directions(cut, north);
  const Axis columns(cut, direction, 0);
  const Axis rows(cut, direction, 1);
  const Position x = packed(cut.vertex_count(), columns.edges());
  const Position y = packed(cut.vertex_count(), rows.edges());
  std::vector<GridPoint> points;
  for (std::size_t v = 0; v < graph.vertex_count(); ++v)
    points.push_back({place_distance * x[columns.line(v)], place_distance * y[rows.line(v)]});
  return points;
}

}  // namespace

std::vector<GridPoint> grid_layout(const PlaneGraph& graph, std::size_t north) {
  const std::vector<GridPoint> start = rectangular_layout(graph, north);
  const std::vector<int> direction = directions(graph, north);
  const Axis columns(graph, direction, 0);
  const Axis rows(graph, direction, 1);
  Position x(graph.vertex_count()), y(graph.vertex_count());
  for (std::size_t v = 0; v < start.size(); ++v) {
    x[columns.line(v)] = start[v].x;
    y[rows.line(v)] = start[v].y;
  }
  for (int round = 0; round < rounds; ++round) {
    const Position x_before = x, y_before = y;
    x = pulled_together(x, neighbours(graph, columns, x, rows, y), columns.edges());
    y = pulled_together(y, neighbours(graph, rows, y, columns, x), rows.edges());
    if (x == x_before && y == y_before) break;
  }
  std::vector<GridPoint> points;
  for (std::size_t v = 0; v < graph.vertex_count(); ++v)
    points.push_back({x[columns.line(v)], y[rows.line(v)]});
  return points;
}

}  // namespace asterism
