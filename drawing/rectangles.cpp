#include "drawing/rectangles.hpp"

#include <optional>
#include <stdexcept>

#include "drawing/orthogonal_shape.hpp"

namespace asterism {
namespace {

using Edge = PlaneGraph::Edge;

/// The dart that a straight prolongation of d would run into; none if it leaves the graph.
std::optional<std::size_t> in_front(const PlaneGraph& graph, std::size_t dart) {
  int turned = graph[dart].turn;
  for (std::size_t d = graph[dart].next; d != dart; d = graph[d].next) {
    if (turned == 1) return d;
    turned += graph[d].turn;
  }
  return std::nullopt;
}

//     <--- rest -- * <-- front        seen with d going up: the prolongation ends in the middle of
//                  |                  the edge in front
//                  * (turn < 0)
//                  d
//
void prolong(PlaneGraph& graph, std::size_t dart, std::size_t front) {
  const std::size_t rest = graph.split(front);
  const std::size_t helper = graph.add_edge(graph.target(dart), graph[rest].origin, Edge::helper);
  graph.set_next(helper ^ 1, graph[dart].next);
  graph.set_turn(helper ^ 1, graph[dart].turn + 2);
  graph.set_next(dart, helper);
  graph.set_turn(dart, 0);
  graph.set_next(helper, rest);
  graph.set_turn(helper, 1);
  graph.set_next(front, helper ^ 1);
  graph.set_turn(front, 1);
}

/// A dart of the outer face from whose end one can go straight on for ever.
std::size_t way_out(const PlaneGraph& graph) {
  for (const std::size_t first : graph.faces().first)
    if (turns(graph, first) == -4)
      for (const std::size_t d : graph.face(first))
        if (graph[d].turn < 0 && !in_front(graph, d)) return d;
  throw std::logic_error("no face has the turns of an outer one");
}

/// A rectangle of four helper edges round the graph, and a fifth edge to it. Returns one dart of
/// the frame's outside.
std::size_t add_frame(PlaneGraph& graph) {
  const std::size_t out = way_out(graph);
  std::vector<std::size_t> corners, frame;
  for (int i = 0; i < 4; ++i) corners.push_back(graph.add_vertex());
  for (std::size_t i = 0; i < 4; ++i)
    frame.push_back(graph.add_edge(corners[i], corners[(i + 1) % 4], Edge::helper));
  for (std::size_t i = 0; i < 4; ++i) {
    graph.set_next(frame[i], frame[(i + 1) % 4]);
    graph.set_turn(frame[i], 1);
    graph.set_next(frame[(i + 1) % 4] ^ 1, frame[i] ^ 1);
    graph.set_turn(frame[i] ^ 1, -1);
  }
  prolong(graph, out, frame[0]);
  return frame[0] ^ 1;
}

}  // namespace

PlaneGraph cut_into_rectangles(const PlaneGraph& graph) {
  PlaneGraph cut = graph;
  const std::size_t outside = add_frame(cut);
  const PlaneGraph::Faces faces = cut.faces();
  const std::size_t outer = faces.of_dart[outside];
  for (std::size_t d = 0; d < cut.dart_count(); ++d)
    if (cut[d].turn < 0 && (d >= faces.of_dart.size() || faces.of_dart[d] != outer))
      prolong(cut, d, in_front(cut, d).value());
  return cut;
}

std::vector<int> directions(const PlaneGraph& graph, std::size_t north) {
  std::vector<int> direction(graph.dart_count(), -1);
  std::vector<std::size_t> open{north};
  direction[north] = 1;
  const auto reach = [&](std::size_t dart, int towards) {
    if (direction[dart] >= 0) return;
    direction[dart] = (towards + 8) % 4;
    open.push_back(dart);
  };
  while (!open.empty()) {
    const std::size_t d = open.back();
    open.pop_back();
    reach(d ^ 1, direction[d] + 2);
    reach(graph[d].next, direction[d] + graph[d].turn);
  }
  return direction;
}

}  // namespace asterism
