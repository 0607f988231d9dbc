#include "drawing/straight_drawing.hpp"

// g++ 12 does not see that Boost finds a rightmost vertex in every canonical order.
#ifndef __clang__
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>
#include <boost/graph/chrobak_payne_drawing.hpp>
#include <boost/graph/make_biconnected_planar.hpp>
#include <boost/graph/make_maximal_planar.hpp>
#include <boost/graph/planar_canonical_ordering.hpp>
#include <boost/property_map/property_map.hpp>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

namespace asterism {
namespace {

using Edges = std::set<std::pair<std::size_t, std::size_t>>;  ///< smaller vertex first
using Points = std::vector<MapDrawing::Point>;
using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                                    boost::property<boost::vertex_index_t, std::size_t>,
                                    boost::property<boost::edge_index_t, std::size_t>>;
using Edge = boost::graph_traits<Graph>::edge_descriptor;
using Embedding = std::vector<std::vector<Edge>>;

/// Neighbours in number are neighbours on the circle, one unit apart.
Points on_circle(std::size_t vertices) {
  Points result;
  const double n = static_cast<double>(std::max(vertices, std::size_t{2}));
  const double radius = 0.5 / std::sin(std::numbers::pi / n);
  for (std::size_t v = 0; v < vertices; ++v) {
    const double angle =
        std::numbers::pi / 2 - 2 * std::numbers::pi * static_cast<double>(v) / n;  // from the top
    result.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return result;
}

bool cross_on_circle(const Edges& edges) {
  for (const auto& [a, b] : edges)
    for (const auto& [c, d] : edges)
      if (a < c && c < b && b < d) return true;
  return false;
}

void number_edges(Graph& graph) {
  std::size_t next = 0;
  for (const Edge& edge : boost::make_iterator_range(boost::edges(graph)))
    boost::put(boost::edge_index, graph, edge, next++);
}

/// A list of something for each vertex, as Boost asks for it.
template <class List>
auto by_vertex(List& list, const Graph& graph) {
  return boost::make_iterator_property_map(list.begin(), boost::get(boost::vertex_index, graph));
}

/// An order of the edges round each vertex, if there is one for a drawing in the plane.
std::optional<Embedding> embedding_of(Graph& graph) {
  number_edges(graph);
  Embedding embedding(boost::num_vertices(graph));
  if (!boost::boyer_myrvold_planarity_test(
          boost::boyer_myrvold_params::graph = graph,
          boost::boyer_myrvold_params::embedding = by_vertex(embedding, graph)))
    return std::nullopt;
  return embedding;
}

/// On a grid of 2 n - 4 by n - 2 steps.   @pre at least three vertices
std::optional<Points> on_grid(std::size_t vertices, const Edges& edges) {
  Graph graph(vertices);
  for (const auto& [a, b] : edges) boost::add_edge(a, b, graph);
  std::optional<Embedding> embedding = embedding_of(graph);
  if (!embedding) return std::nullopt;
  // The drawing is of a triangulation: edges are added for it, and not shown.
  boost::make_biconnected_planar(graph, by_vertex(*embedding, graph));
  embedding = embedding_of(graph);
  boost::make_maximal_planar(graph, by_vertex(*embedding, graph));
  embedding = embedding_of(graph);
  std::vector<boost::graph_traits<Graph>::vertex_descriptor> order;
  boost::planar_canonical_ordering(graph, by_vertex(*embedding, graph), std::back_inserter(order));
  struct GridPoint {
    std::size_t x = 0;
    std::size_t y = 0;
  };
  std::vector<GridPoint> grid(vertices);
  boost::chrobak_payne_straight_line_drawing(graph, by_vertex(*embedding, graph), order.begin(),
                                             order.end(), by_vertex(grid, graph));
  Points result;
  for (const auto& [x, y] : grid)
    result.push_back({static_cast<double>(x), static_cast<double>(y)});
  return result;
}

}  // namespace

StraightDrawing draw_straight(std::size_t vertices,
                              std::span<const std::pair<std::size_t, std::size_t>> edges) {
  Edges simple;
  for (const auto& [a, b] : edges)
    if (a != b) simple.insert(std::minmax(a, b));
  if (!cross_on_circle(simple)) return {on_circle(vertices), true};
  if (auto points = on_grid(vertices, simple)) return {std::move(*points), true};
  return {on_circle(vertices), false};
}

}  // namespace asterism
