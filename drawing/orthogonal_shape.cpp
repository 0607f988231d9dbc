#include "drawing/orthogonal_shape.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "drawing/min_cost_flow.hpp"

namespace asterism {
namespace {

using Edge = PlaneGraph::Edge;

// What a quarter turn costs. A bend in a segment is a nuisance, two in one segment a bigger one; a
// path that bends inside a dead end's place looks wrong.
constexpr long bend_costs[] = {10, 12, 14, 16};
constexpr long further_bend_cost = 20;
constexpr long place_bend_cost = 9;
constexpr std::size_t outer_faces_tried = 6;

/// An arc that carries left turns into the face of `gains` (+1) out of the face of `loses` (-1):
/// at the ends of these darts (corner of a place), or along the edge of `gains` (a bend in it).
struct TurnArc {
  std::size_t gains;
  std::size_t loses;
  bool is_bend;
};

struct TurnNetwork {
  std::vector<FlowArc> arcs;
  std::vector<TurnArc> meanings;
  std::vector<long> demand;  ///< left turns still wanted by inner faces, then by quarters of cages

  void add(std::size_t from_face, std::size_t to_face, long capacity, long cost, TurnArc meaning) {
    if (from_face == to_face) return;
    arcs.push_back({from_face, to_face, capacity, cost});
    meanings.push_back(meaning);
  }
};

/// Rims run clockwise round their places, so their second darts have the inside to the left.
bool is_inside_cage(const PlaneGraph& graph, std::size_t dart) {
  return graph.edge(dart) == Edge::cage && dart % 2 == 1;
}

/// Makes a cage a rectangle: one of the two outer corners of a vertex of its rim gives its turn to
/// the inner one, once in each quarter of the rim, so that the arms are spread over the four sides.
void add_cage(TurnNetwork& network, const PlaneGraph& graph, const PlaneGraph::Faces& faces,
              std::size_t first) {
  const std::vector<std::size_t> rim = graph.face(first);
  const std::size_t quarters = network.demand.size();
  network.demand.resize(quarters + 4, 1);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const std::size_t before = graph[rim[i]].next ^ 1;  // arrives at the same vertex, outside
    const std::size_t inward = graph[before].next ^ 1;  // the arm, arriving
    const std::size_t quarter = quarters + 4 * i / rim.size();
    for (const std::size_t loses : {before, inward})
      network.add(faces.of_dart[loses], quarter, 1, 0, {rim[i], loses, false});
  }
}

TurnNetwork turn_network(const PlaneGraph& graph, const PlaneGraph::Faces& faces) {
  TurnNetwork network;
  for (const std::size_t first : faces.first)
    network.demand.push_back(is_inside_cage(graph, first) ? 0 : 4 - turns(graph, first));
  for (std::size_t d = 0; d < graph.dart_count(); ++d) {
    const std::size_t face = faces.of_dart[d];
    const std::size_t other = faces.of_dart[d ^ 1];
    const std::size_t next = graph[d].next;
    if (graph.edge(d) == Edge::segment) {
      for (const long cost : bend_costs) network.add(other, face, 1, cost, {d, d ^ 1, true});
      network.add(other, face, static_cast<long>(graph.dart_count()), further_bend_cost,
                  {d, d ^ 1, true});
    }
    if (graph.degree(d) == 2) {
      const std::size_t across = next ^ 1;
      network.add(faces.of_dart[across], face, 1, place_bend_cost, {d, across, false});
    }
    if (is_inside_cage(graph, d) && d == faces.first[face]) add_cage(network, graph, faces, d);
  }
  return network;
}

Flow turn_flow(const TurnNetwork& network, std::size_t outer) {
  std::vector<long> supply;
  for (const long wanted : network.demand) supply.push_back(-wanted);
  supply[outer] += 8;
  return cheapest_flow(network.arcs, supply, std::vector<long>(supply.size(), 0));
}

/// The faces most like an outer one, by their natural turns.
std::vector<std::size_t> outer_candidates(const PlaneGraph& graph, const PlaneGraph::Faces& faces) {
  std::vector<std::size_t> candidates;
  for (std::size_t face = 0; face < faces.first.size(); ++face) {
    const std::size_t first = faces.first[face];
    if (!is_inside_cage(graph, first)) candidates.push_back(face);
  }
  std::stable_sort(candidates.begin(), candidates.end(), [&](std::size_t one, std::size_t other) {
    return turns(graph, faces.first[one]) < turns(graph, faces.first[other]);
  });
  candidates.resize(std::min(candidates.size(), outer_faces_tried));
  return candidates;
}

}  // namespace

int turns(const PlaneGraph& graph, std::size_t dart) {
  int sum = 0;
  for (const std::size_t d : graph.face(dart)) sum += graph[d].turn;
  return sum;
}

PlaneGraph with_orthogonal_shape(const PlaneGraph& graph) {
  const PlaneGraph::Faces faces = graph.faces();
  const TurnNetwork network = turn_network(graph, faces);
  std::optional<Flow> best;
  for (const std::size_t outer : outer_candidates(graph, faces))
    if (const Flow flow = turn_flow(network, outer); !best || flow.cost < best->cost) best = flow;

  PlaneGraph shaped = graph;
  for (std::size_t a = 0; a < network.arcs.size(); ++a) {
    const auto& [gains, loses, is_bend] = network.meanings[a];
    if (is_bend) continue;
    const int units = static_cast<int>(best->units[a]);
    shaped.set_turn(gains, shaped[gains].turn + units);
    shaped.set_turn(loses, shaped[loses].turn - units);
  }
  for (std::size_t a = 0; a < network.arcs.size(); ++a) {
    const auto& [gains, loses, is_bend] = network.meanings[a];
    if (!is_bend) continue;
    for (long unit = 0; unit < best->units[a]; ++unit) {
      const std::size_t rest = shaped.split(gains);
      shaped.set_turn(gains, 1);
      shaped.set_turn(rest ^ 1, -1);
    }
  }
  return shaped;
}

}  // namespace asterism
