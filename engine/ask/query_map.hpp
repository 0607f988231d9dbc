#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/id.hpp"
#include "core/id_vector.hpp"
#include "core/topological_map.hpp"
#include "engine/arm_table.hpp"

namespace asterism {

/// A map as queries see it, one after another: only what is asked for is computed, in buffers that
/// the next map uses again.
///
/// Says what make_map would write out, at a small part of its cost, since a tree may have millions
/// of maps.
class QueryMap {
 public:
  explicit QueryMap(const Trace& trace);

  /// Goes on to another map of the trace, by its data association, which must outlive what is
  /// asked.
  /// @pre it covers all visits
  void set(std::span<const Arrival> arrivals);

  PlaceId place(VisitId visit) const { return arrivals_[visit.index()].place; }
  std::size_t places() const;
  /// Whether a segment joins the places.
  bool adjacent(PlaceId one, PlaceId other) const;
  /// The least number of segments from one place to the other.
  std::size_t steps(PlaceId from, PlaceId to);

  std::size_t segments();
  std::size_t paths();
  /// The path that the robot faces when it leaves this visit.  @pre it does
  PathId path_of(VisitId visit);
  /// The places of a path in order, along one of its directions.
  std::span<const PlaceId> places_of(PathId path);
  /// Whether it closes on itself: only where axiom (8) is not in force.
  bool is_closed(PathId path);

 private:
  struct Path {
    std::size_t first;  ///< of places_of_paths_
    std::size_t end;
    bool is_closed;
  };
  static constexpr std::size_t none = SIZE_MAX;

  void link();
  void write_paths();
  void write_path(ArmId arm);
  std::optional<ArmId> end_of_path(ArmId arm) const;

  ArmTable table_;
  std::span<const Arrival> arrivals_;
  bool has_links_ = false;
  bool has_paths_ = false;

  IdVector<PlaceId, VisitId> first_visit_;
  IdVector<VisitId, ArmId> left_;  ///< arm by which it was left
  std::vector<std::pair<ArmId, ArmId>> segments_;
  IdVector<ArmId, ArmId> linked_;  ///< the gateway at the other end of its segment
  std::vector<Path> paths_;
  std::vector<PlaceId> places_of_paths_;
  IdVector<ArmId, std::size_t> path_of_arm_;
  std::vector<std::size_t> steps_;  ///< to each place
};

}  // namespace asterism
