#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/topological_map.hpp"

namespace asterism {

/// A graph with the circular order of edges at each vertex, as darts: edge e is darts 2e and
/// 2e + 1, one in each direction. Edges meet at right angles: `turn` is in quarter turns.
///
/// Faces lie to the left of their darts, as in `faces`; so next(d) leaves by the edge clockwise
/// after the one d came by, and turns round an inner face add up to 4, round the outer one to -4.
class PlaneGraph {
 public:
  enum class Edge {
    segment,
    stub,   ///< an arm without a segment, to a vertex of its own
    cage,   ///< the rim of a place with more than four arms: a ring, one vertex an arm
    helper  ///< cuts faces into rectangles
  };
  struct Dart {
    std::size_t origin = 0;
    std::size_t next = 0;
    std::size_t previous = 0;
    int turn = 0;                      ///< at its end, from it to `next`: 1 left, -1 right
    std::optional<PlaceArm> arm = {};  ///< the arm of a place that leaves along it
  };

  std::size_t vertex_count() const { return vertex_count_; }
  std::size_t dart_count() const { return darts_.size(); }
  const Dart& operator[](std::size_t dart) const { return darts_[dart]; }
  std::size_t target(std::size_t dart) const { return darts_[dart ^ 1].origin; }
  Edge edge(std::size_t dart) const { return edges_[dart / 2]; }
  /// The dart that goes straight on at the end of d: across a crossing, round a bend.
  std::size_t onward(std::size_t dart) const;
  std::size_t degree(std::size_t dart) const;  ///< of its target
  /// The darts round the face to the left of this one, from it on.
  std::vector<std::size_t> face(std::size_t dart) const;
  /// One dart of each face, and for each dart the number of its face.
  struct Faces {
    std::vector<std::size_t> first;
    std::vector<std::size_t> of_dart;
  };
  Faces faces() const;

  std::size_t add_vertex() { return vertex_count_++; }
  std::size_t add_edge(std::size_t from, std::size_t to, Edge kind);  ///< its first dart
  void set_arm(std::size_t dart, PlaceArm arm) { darts_[dart].arm = arm; }
  void set_turn(std::size_t dart, int turn) { darts_[dart].turn = turn; }
  void set_next(std::size_t dart, std::size_t next);
  void set_origin(std::size_t dart, std::size_t vertex) { darts_[dart].origin = vertex; }
  void set_kind(std::size_t dart, Edge kind) { edges_[dart / 2] = kind; }
  /// Makes `leaving` the clockwise order of darts at their vertex.
  void set_order(const std::vector<std::size_t>& leaving);
  /// Puts a vertex into the edge of d, which now ends there; the edge goes on with the dart
  /// returned.
  std::size_t split(std::size_t dart);

 private:
  std::size_t vertex_count_ = 0;
  std::vector<Dart> darts_;
  std::vector<Edge> edges_;
};

/// The map as a plane graph. A place with at most four arms is a vertex, one with more a cage.
/// Where the map is not planar, segments that cannot be drawn otherwise pass through crossings,
/// vertices of degree four. Turns are the natural ones: 90 degrees between four arms, 180 between
/// two.
PlaneGraph plane_graph(const TopologicalMap& map);

}  // namespace asterism
