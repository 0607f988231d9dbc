#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <vector>

#include "core/id.hpp"
#include "core/id_vector.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"

namespace asterism {

/// Held by flat arrays of arms where there is none.
inline constexpr ArmId no_arm(std::numeric_limits<std::uint32_t>::max());

/// An arm, or none, in one word. A std::optional takes two, and in the hot loops of the search for
/// minimal models it is written in two halves and read as a whole, which stalls the processor.
class OptionalArm {
 public:
  constexpr OptionalArm() = default;
  constexpr OptionalArm(ArmId arm) : arm_(arm) {}

  constexpr explicit operator bool() const { return arm_ != no_arm; }
  /// The arm; no_arm where there is none.
  constexpr ArmId operator*() const { return arm_; }

 private:
  ArmId arm_ = no_arm;
};

/// Names every dstate there can be: arm i of the place first seen at visit k.
///
/// The arms of all visits' stars, numbered in a row. A hypothesis is then a naming: for each visit,
/// the arm the robot came in by, which is an arm of the visit's own star if the place is new.
///
/// Threads may read one at once; what changes it needs it alone.
class ArmTable {
 public:
  ArmTable() = default;
  /// Of all visits of a trace.  @throws as append()
  explicit ArmTable(const Trace& trace) : ArmTable(trace, trace.visits.size()) {}
  /// Of its first visits.  @throws as append()
  ArmTable(const Trace& trace, std::size_t visits);

  /// @throws std::invalid_argument if the visit lacks an arm it needs, or follows one not left
  /// @throws Error                 if there are more visits or arms than the engine can number
  void append(const Visit& visit);
  /// Forgets all visits but the first ones.
  void keep_first(std::size_t visits);
  /// The robot leaves the last visit, as its own star's arm `left_by`.
  void leave(std::size_t left_by);

  /// Number of arms.
  std::size_t size() const { return arms_.size(); }
  /// Number of visits.
  std::size_t visits() const { return visits_.size(); }
  /// Number of different views so far.
  std::size_t views() const { return view_numbers_.size(); }
  IdRange<ArmId> all_arms() const { return IdRange<ArmId>(size()); }
  IdRange<VisitId> all_visits() const { return IdRange<VisitId>(visits()); }
  const Trace& trace() const { return trace_; }

  /// The arms of the visit's own star, in order.
  IdRange<ArmId> arms(VisitId visit) const {
    const VisitFacts& facts = visits_[visit];
    return {facts.first_arm, ArmId(facts.first_arm.index() + facts.star_size)};
  }
  ArmId first_arm(VisitId visit) const { return visits_[visit].first_arm; }
  /// Arm i of the visit's own star.
  ArmId arm(VisitId visit, std::size_t i) const { return ArmId(first_arm(visit).index() + i); }
  std::uint32_t star_size(VisitId visit) const { return visits_[visit].star_size; }
  /// Arm of the visit's own star by which it was entered (the first, if it does not say).
  ArmId entered(VisitId visit) const { return visits_[visit].entered; }
  /// The gateways of the visit's own star, in order.
  std::span<const ArmId> gateways(VisitId visit) const {
    const VisitFacts& facts = visits_[visit];
    return std::span(gateways_).subspan(facts.first_gateway, facts.gateways);
  }
  /// The gateways of the visit's own star, clockwise after the arm entered by, without that.
  std::span<const ArmId> gateways_after_entered(VisitId visit) const {
    const VisitFacts& facts = visits_[visit];
    return std::span(gateways_after_entered_).subspan(facts.first_gateway, facts.gateways - 1);
  }
  /// What was seen on arrival, read from the arm entered by.
  ViewId seen(VisitId visit) const { return visits_[visit].seen; }

  /// The other direction of the arm's local-path.
  ArmId opposite(ArmId arm) const { return arms_[arm].opposite; }
  /// The star as read clockwise from the arm.
  ViewId view(ArmId arm) const { return arms_[arm].view; }
  VisitId visit_of(ArmId arm) const { return arms_[arm].visit; }
  /// Position of the arm in its star.
  std::uint32_t position(ArmId arm) const {
    return static_cast<std::uint32_t>(arm.index() - first_arm(visit_of(arm)).index());
  }
  bool has_gateway(ArmId arm) const { return arms_[arm].has_gateway; }
  /// The arm `steps` clockwise from `arm` in the star of its place.
  ArmId clockwise(ArmId arm, std::size_t steps) const {
    const ArmFacts& facts = arms_[arm];
    std::size_t reached = arm.index() + steps;
    while (reached >= facts.star_end)
      reached -= facts.star_size;  // a division costs as much as a node
    return ArmId(reached);
  }
  /// The arm the robot left the visit by, if it came in by `entered`.
  ArmId left(VisitId visit, ArmId entered) const {
    return clockwise(entered, visits_[visit].left_steps);
  }

  /// The hypothesis in which visit k was entered by arm named[k].
  std::vector<Arrival> arrivals(std::span<const ArmId> named) const;
  /// For each visit, the arm by which it was entered, of the star of the place's first visit.
  /// @pre places are numbered by first visit
  std::vector<ArmId> named(std::span<const Arrival> arrivals) const;

 private:
  struct ArmFacts {
    VisitId visit;
    ArmId opposite;
    ViewId view;
    std::uint32_t star_end;   ///< one past the last of the star's arms
    std::uint32_t star_size;  ///< as its visit has, at hand
    bool has_gateway;
  };
  struct VisitFacts {
    ArmId first_arm;
    std::uint32_t star_size;
    ArmId entered;
    ViewId seen;               ///< view of `entered`, at hand
    std::uint32_t left_steps;  ///< from the arm entered by, clockwise
    std::uint32_t first_gateway;
    std::uint32_t gateways;
  };

  void set_left_steps();

  Trace trace_;
  IdVector<ArmId, ArmFacts> arms_;
  IdVector<VisitId, VisitFacts> visits_;
  std::vector<ArmId> gateways_;
  std::vector<ArmId> gateways_after_entered_;  ///< as long: one to spare a visit
  std::map<std::vector<std::size_t>, ViewId> view_numbers_;
};

}  // namespace asterism
