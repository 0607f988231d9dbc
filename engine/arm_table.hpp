#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/topological_map.hpp"
#include "core/trace.hpp"

namespace asterism {

/// Number of an arm in an ArmTable.
using ArmIndex = std::uint32_t;

/// Names every dstate there can be: arm i of the place first seen at visit k.
///
/// The arms of all visits' stars, numbered in a row. A hypothesis is then a naming: for each visit,
/// the arm the robot came in by, which is an arm of the visit's own star if the place is new.
class ArmTable {
 public:
  ArmTable() = default;
  /// Of all visits of a trace.  @throws as append()
  explicit ArmTable(const Trace& trace) : ArmTable(trace, trace.visits.size()) {}
  /// Of its first visits.
  ArmTable(const Trace& trace, std::size_t visits);

  /// @throws std::invalid_argument if the visit lacks an arm it needs, or follows one not left
  /// @throws Error                 if there are more visits or arms than the engine can number
  void append(const Visit& visit);
  /// Forgets all visits but the first ones.
  void keep_first(std::size_t visits);
  /// The robot leaves the last visit, as its own star's arm `left_by`.
  void leave(std::size_t left_by);

  std::size_t size() const { return arms_.size(); }
  std::size_t visits() const { return trace_.visits.size(); }
  const Trace& trace() const { return trace_; }

  ArmIndex first_arm(std::size_t visit) const { return visits_[visit].first_arm; }
  ArmIndex star_size(std::size_t visit) const { return visits_[visit].star_size; }
  /// ArmIndex of the visit's own star by which it was entered (the first, if it does not say).
  ArmIndex entered(std::size_t visit) const { return visits_[visit].entered; }
  /// The gateways of the visit's own star, in order.
  std::span<const ArmIndex> gateways(std::size_t visit) const {
    const VisitFacts& facts = visits_[visit];
    return std::span(gateways_).subspan(facts.first_gateway, facts.gateways);
  }
  /// The same clockwise from the arm entered by, without that.
  std::span<const ArmIndex> gateways_after_entered(std::size_t visit) const {
    const VisitFacts& facts = visits_[visit];
    return std::span(gateways_after_entered_).subspan(facts.first_gateway, facts.gateways - 1);
  }
  /// What was seen on arrival, read from the arm entered by: views are equal iff their numbers are.
  ArmIndex seen(std::size_t visit) const { return visits_[visit].seen; }
  /// Number of different views so far.
  std::size_t views() const { return view_numbers_.size(); }

  ArmIndex opposite(ArmIndex arm) const { return arms_[arm].opposite; }
  ArmIndex view(ArmIndex arm) const { return arms_[arm].view; }
  ArmIndex visit_of(ArmIndex arm) const { return arms_[arm].visit; }
  bool has_gateway(ArmIndex arm) const { return arms_[arm].has_gateway; }
  /// The arm `steps` clockwise from `arm` in the star of its place.
  ArmIndex clockwise(ArmIndex arm, ArmIndex steps) const {
    const ArmFacts& facts = arms_[arm];
    arm += steps;
    while (arm >= facts.star_end) arm -= facts.star_size;  // a division costs as much as a node
    return arm;
  }
  /// The arm the robot left visit k by, if it came in by `entered`.
  ArmIndex left(std::size_t visit, ArmIndex entered) const {
    return clockwise(entered, visits_[visit].left_steps);
  }

  /// The hypothesis in which visit k was entered by arm named[k].
  std::vector<Arrival> arrivals(std::span<const ArmIndex> named) const;
  /// @pre places are numbered by first visit
  std::vector<ArmIndex> named(std::span<const Arrival> arrivals) const;

 private:
  struct ArmFacts {
    ArmIndex visit;
    ArmIndex opposite;
    ArmIndex view;
    ArmIndex star_end;   ///< of the place's arms
    ArmIndex star_size;  ///< the same as its visit has, at hand
    bool has_gateway;
  };
  struct VisitFacts {
    ArmIndex first_arm;
    ArmIndex star_size;
    ArmIndex entered;
    ArmIndex seen;        ///< view of `entered`, at hand
    ArmIndex left_steps;  ///< from the arm entered by, clockwise
    ArmIndex first_gateway;
    ArmIndex gateways;
  };

  void set_left_steps();

  Trace trace_;
  std::vector<ArmFacts> arms_;
  std::vector<VisitFacts> visits_;
  std::vector<ArmIndex> gateways_;
  std::vector<ArmIndex> gateways_after_entered_;  ///< as long: one to spare a visit
  std::map<std::vector<std::size_t>, ArmIndex> view_numbers_;
};

}  // namespace asterism
