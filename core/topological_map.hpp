#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/id.hpp"
#include "core/star.hpp"
#include "core/trace.hpp"

namespace asterism {

/// An arm of a place of the map: its position in the place's star as listed at the first visit.
struct PlaceArm {
  PlaceId place;
  std::size_t arm;
  friend auto operator<=>(const PlaceArm&, const PlaceArm&) = default;
};

/// Data association: where one visit was, and the arm the robot came in by (absent where the trace
/// does not say: at most at the first visit).
struct Arrival {
  PlaceId place;
  std::optional<std::size_t> entered;
  friend auto operator<=>(const Arrival&, const Arrival&) = default;
};

/// One explanation of a trace, written out: places, paths, segments.               [theory §9]
/// Of a trace that is cut it is in pieces, with no place in two: at a cut there is no arm left by,
/// and none entered by.
struct TopologicalMap {
  /// One place: its star as listed at its first visit.
  struct Place {
    Star star;
    VisitId first_visit;
  };
  /// Places in order along the + direction, which leaves by `ends[1]`. A path that closes on itself
  /// (possible only where axiom (8) is not in force) has no ends.
  struct Path {
    std::vector<PlaceId> places;
    std::vector<PlaceArm> ends;  ///< two arms, smaller first
  };
  using Segment = std::pair<PlaceArm, PlaceArm>;  ///< smaller gateway first

  std::vector<PlaceId> visits;                      ///< place of each visit
  std::vector<std::optional<std::size_t>> entered;  ///< arm of that place
  std::vector<std::optional<std::size_t>> left;     ///< arm of that place
  std::vector<Place> places;                        ///< numbered by first visit
  std::vector<Path> paths;                          ///< numbered by smallest arm
  std::vector<Segment> segments;                    ///< sorted
};

/// Writes a data association out as a map. Explains the first arrivals.size() visits of the trace.
///
/// The arm left by is as many steps clockwise from the arm entered by as in the visit's own star.
/// Asks no axiom: what the trace does not license is written out all the same.
///
/// @pre  places are numbered by first visit: each is at most one more than the largest before it
/// @throws std::invalid_argument otherwise
TopologicalMap make_map(const Trace& trace, std::span<const Arrival> arrivals);

/// The visits of each piece of a map, by how they were travelled: first and last of each.
std::vector<std::array<std::size_t, 2>> pieces_of(const TopologicalMap& map);

/// The data association a map was made from.
std::vector<Arrival> arrivals(const TopologicalMap& map);

/// The arm of place star `star` by which the robot left, given the one entered by there.
std::size_t left_arm(const Visit& visit, const Star& star, std::size_t entered);

}  // namespace asterism
