#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/topological_map.hpp"
#include "engine/arm_table.hpp"
#include "engine/ask/turns.hpp"

namespace asterism {

/// One map as a robot finds its way in it: what it stands at is the arm it came in by, which is one
/// of the place's first visit.
class RouteMap {
 public:
  /// @param table  of the whole trace; outlives this
  explicit RouteMap(const ArmTable& table) : table_(&table) {}

  /// Goes on to another map of the trace, by its data association.  @pre it covers all visits
  void set(std::span<const Arrival> arrivals);

  /// The arm by which the robot came in at a visit.
  ArmId arrived(VisitId visit) const { return arrived_[visit.index()]; }
  /// A place, by its first visit.
  VisitId place(ArmId arm) const { return table_->visit_of(arm); }
  std::size_t turns(ArmId arm) const { return table_->star_size(place(arm)); }
  /// The arm it comes in by after this turn and a travel, where the map knows the travel.
  std::optional<ArmId> after(ArmId arm, std::size_t turn) const {
    if (turn >= turns(arm)) return std::nullopt;
    const ArmId end = leads_to_[table_->clockwise(arm, turn)];
    if (end == no_arm) return std::nullopt;
    return end;
  }

  /// Whether this route can be gone from a visit, and ends at the place of another.
  bool leads(VisitId from, VisitId to, std::span<const std::size_t> route) const;
  /// Of the shortest routes, the first by turns; nothing if there is none.
  std::optional<Turns> shortest(VisitId from, VisitId to) const;
  /// Travels that it takes at least from each place, by first visit, to that of a visit; `far`
  /// where none lead there.
  IdVector<VisitId, std::size_t> travels_to(VisitId visit) const;
  static constexpr std::size_t far = SIZE_MAX / 2;

 private:
  const ArmTable* table_;
  std::vector<ArmId> arrived_;
  IdVector<ArmId, ArmId> leads_to_;  ///< the gateway at the other end of its segment
};

}  // namespace asterism
