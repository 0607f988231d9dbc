#include "drawing/plane_graph.hpp"

#include <deque>
#include <map>
#include <utility>

#include "planarity/euler.hpp"

namespace asterism {

std::size_t PlaneGraph::onward(std::size_t dart) const {
  const std::size_t next = darts_[dart].next;
  return degree(dart) == 4 ? darts_[next ^ 1].next : next;
}

std::size_t PlaneGraph::degree(std::size_t dart) const {
  std::size_t count = 1;
  for (std::size_t d = darts_[dart].next ^ 1; d != dart; d = darts_[d].next ^ 1) ++count;
  return count;
}

std::vector<std::size_t> PlaneGraph::face(std::size_t dart) const {
  std::vector<std::size_t> darts{dart};
  for (std::size_t d = darts_[dart].next; d != dart; d = darts_[d].next) darts.push_back(d);
  return darts;
}

PlaneGraph::Faces PlaneGraph::faces() const {
  Faces result;
  result.of_dart.assign(darts_.size(), darts_.size());
  for (std::size_t first = 0; first < darts_.size(); ++first) {
    if (result.of_dart[first] != darts_.size()) continue;
    for (const std::size_t d : face(first)) result.of_dart[d] = result.first.size();
    result.first.push_back(first);
  }
  return result;
}

std::size_t PlaneGraph::add_edge(std::size_t from, std::size_t to, Edge kind) {
  const std::size_t dart = darts_.size();
  darts_.push_back({.origin = from});
  darts_.push_back({.origin = to});
  edges_.push_back(kind);
  return dart;
}

void PlaneGraph::set_next(std::size_t dart, std::size_t next) {
  darts_[dart].next = next;
  darts_[next].previous = dart;
}

void PlaneGraph::set_order(const std::vector<std::size_t>& leaving) {
  for (std::size_t i = 0; i < leaving.size(); ++i)
    set_next(leaving[i] ^ 1, leaving[(i + 1) % leaving.size()]);
}

std::size_t PlaneGraph::split(std::size_t dart) {
  const std::size_t next = darts_[dart].next;
  const std::size_t before_back = darts_[dart ^ 1].previous;
  const std::size_t rest = add_edge(add_vertex(), target(dart), edge(dart));
  if (next == (dart ^ 1)) {
    set_next(rest, rest ^ 1);
  } else {
    set_next(rest, next);
    set_next(before_back, rest ^ 1);
  }
  darts_[rest].turn = std::exchange(darts_[dart].turn, 0);
  darts_[rest ^ 1].arm = std::exchange(darts_[dart ^ 1].arm, std::nullopt);
  darts_[dart ^ 1].origin = darts_[rest].origin;
  set_next(dart, rest);
  set_next(rest ^ 1, dart ^ 1);
  return rest;
}

namespace {

using Edge = PlaneGraph::Edge;
using Segment = TopologicalMap::Segment;

class Builder {
 public:
  Builder(const TopologicalMap& map, const std::vector<Segment>& drawn) {
    for (const auto& [one, other] : drawn) {
      linked_.insert({one, other});
      linked_.insert({other, one});
    }
    for (std::size_t p = 0; p < map.places.size(); ++p) {
      const std::size_t arm_count = map.places[p].star.size();
      arm_count <= 4 ? add_place(PlaceId(p), arm_count) : add_cage(PlaceId(p), arm_count);
    }
  }

  /// Draws a segment from stub to stub over as few segments as possible.
  void cross_over(const Segment& segment) {
    std::size_t arriving = leaving_.at(segment.first);
    const std::size_t last = leaving_.at(segment.second);
    graph_.set_kind(arriving, Edge::segment);
    graph_.set_kind(last, Edge::segment);
    const std::vector<std::size_t> crossed = way(arriving, last);
    for (std::size_t i = 0; i < crossed.size(); ++i) {
      const std::size_t rest = graph_.split(crossed[i]);
      const std::size_t crossing = graph_[rest].origin;
      graph_.set_origin(arriving ^ 1, crossing);
      graph_.set_turn(arriving, 1);
      std::size_t onward = last ^ 1;
      if (i + 1 < crossed.size())
        onward = graph_.add_edge(crossing, crossing, Edge::segment);
      else
        graph_.set_origin(onward, crossing);
      // We come from the left of the edge crossed.
      graph_.set_order({arriving ^ 1, rest, onward, crossed[i] ^ 1});
      for (const std::size_t dart : {arriving, rest ^ 1, onward ^ 1, crossed[i]})
        graph_.set_turn(dart, 1);
      arriving = onward;
    }
  }

  PlaneGraph graph() && { return std::move(graph_); }

 private:
  std::size_t add_arm(PlaceArm arm, std::size_t vertex) {
    const auto other = linked_.find(arm);
    const auto joined = other == linked_.end() ? leaving_.end() : leaving_.find(other->second);
    std::size_t dart = 0;
    if (joined != leaving_.end()) {
      dart = joined->second ^ 1;
      graph_.set_origin(dart, vertex);
    } else if (other != linked_.end()) {
      dart = graph_.add_edge(vertex, vertex, Edge::segment);
    } else {
      dart = graph_.add_edge(vertex, graph_.add_vertex(), Edge::stub);
      graph_.set_next(dart, dart ^ 1);
      graph_.set_turn(dart, -2);
    }
    graph_.set_arm(dart, arm);
    leaving_[arm] = dart;
    return dart;
  }

  void add_place(PlaceId place, std::size_t arm_count) {
    const std::size_t vertex = graph_.add_vertex();
    std::vector<std::size_t> leaving;
    for (std::size_t arm = 0; arm < arm_count; ++arm)
      leaving.push_back(add_arm({place, arm}, vertex));
    graph_.set_order(leaving);
    for (const std::size_t dart : leaving) graph_.set_turn(dart ^ 1, arm_count == 4 ? 1 : 0);
  }

  //         out[i]               The cage keeps the clockwise order. Inside it lies a face of its
  //           |                  own, without turns at first.
  //  -rim[i-1]-*--rim[i]-
  //
  void add_cage(PlaceId place, std::size_t arm_count) {
    std::vector<std::size_t> corners, rim, out;
    for (std::size_t arm = 0; arm < arm_count; ++arm) corners.push_back(graph_.add_vertex());
    for (std::size_t arm = 0; arm < arm_count; ++arm) {
      rim.push_back(graph_.add_edge(corners[arm], corners[(arm + 1) % arm_count], Edge::cage));
      out.push_back(add_arm({place, arm}, corners[arm]));
    }
    for (std::size_t arm = 0; arm < arm_count; ++arm) {
      const std::size_t before = rim[(arm + arm_count - 1) % arm_count];
      graph_.set_order({out[arm], rim[arm], before ^ 1});
      graph_.set_turn(out[arm] ^ 1, 1);
      graph_.set_turn(before, 1);
    }
  }

  /// The segments' darts to cross on the way from the end of one stub to that of another.
  std::vector<std::size_t> way(std::size_t from, std::size_t to) const {
    const PlaneGraph::Faces faces = graph_.faces();
    std::vector<std::optional<std::size_t>> entered_over(faces.first.size());
    const std::size_t start = faces.of_dart[from];
    std::deque<std::size_t> queue{start};
    for (; !queue.empty(); queue.pop_front()) {
      for (const std::size_t d : graph_.face(faces.first[queue.front()])) {
        const std::size_t beyond = faces.of_dart[d ^ 1];
        if (graph_.edge(d) != Edge::segment || beyond == start || entered_over[beyond]) continue;
        entered_over[beyond] = d;
        queue.push_back(beyond);
      }
    }
    std::deque<std::size_t> crossed;
    for (std::size_t face = faces.of_dart[to]; face != start; face = faces.of_dart[crossed.front()])
      crossed.push_front(entered_over[face].value());
    return {crossed.begin(), crossed.end()};
  }

  PlaneGraph graph_;
  std::map<PlaceArm, PlaceArm> linked_;      ///< by the segments drawn, both ways
  std::map<PlaceArm, std::size_t> leaving_;  ///< the dart of each arm, while its edge is whole
};

}  // namespace

PlaneGraph plane_graph(const TopologicalMap& map) {
  TopologicalMap planar = map;
  std::vector<Segment> left_over;
  if (!is_planar(map)) {
    planar.segments.clear();
    for (const Segment& segment : map.segments) {
      planar.segments.push_back(segment);
      if (is_planar(planar)) continue;
      planar.segments.pop_back();
      left_over.push_back(segment);
    }
  }
  Builder builder(map, planar.segments);
  for (const Segment& segment : left_over) builder.cross_over(segment);
  return std::move(builder).graph();
}

}  // namespace asterism
