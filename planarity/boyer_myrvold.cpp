#include "planarity/boyer_myrvold.hpp"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>

namespace asterism {

bool is_planar_graph(const TopologicalMap& map) {
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
  Graph graph(map.places.size());
  for (const auto& [one, other] : map.segments)
    boost::add_edge(one.place.index(), other.place.index(), graph);
  return boost::boyer_myrvold_planarity_test(graph);
}

}  // namespace asterism
