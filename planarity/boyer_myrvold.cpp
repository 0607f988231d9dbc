#include "planarity/boyer_myrvold.hpp"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>
#include <vector>

namespace asterism {
namespace {

/// What cannot be drawn holds one of the graphs of Kuratowski, which have at least so many.
constexpr std::size_t least_vertices = 5;
constexpr std::size_t least_edges = 9;

}  // namespace

bool is_planar_graph(const TopologicalMap& map) {
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& [one, other] : map.segments)
    edges.emplace_back(one.place.index(), other.place.index());
  return is_planar_graph(map.places.size(), edges);
}

bool is_planar_graph(std::size_t vertices,
                     std::span<const std::pair<std::size_t, std::size_t>> edges) {
  if (vertices < least_vertices || edges.size() < least_edges) return true;
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
  Graph graph(vertices);
  for (const auto& [one, other] : edges) boost::add_edge(one, other, graph);
  return boost::boyer_myrvold_planarity_test(graph);
}

}  // namespace asterism
