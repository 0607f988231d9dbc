#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/id_vector.hpp"
#include "engine/arm_table.hpp"
#include "engine/minimal/identified_arms.hpp"

namespace asterism {

/// The places of a folding that differ from each other, told by the visits that stand for them.
///
/// They and what joins them are a part of every map to come: what an axiom forbids among them, no
/// map has. The last one settled is undone first.
class SettledPlaces {
 public:
  using Mark = std::size_t;

  explicit SettledPlaces(const ArmTable& table) : table_(table) {}

  /// Begins again: none is settled.
  void reset();
  /// @pre the visit stands for a place not settled
  void settle(VisitId visit);

  Mark mark() const { return visits_.size(); }
  /// @return whether there was anything to undo
  bool undo(Mark mark);

  bool contains(VisitId visit) const { return is_settled_[visit]; }
  /// In the order of settling.
  std::span<const VisitId> visits() const { return visits_; }
  /// Their arms, a bit an arm.
  std::span<const std::uint64_t> arms() const { return arms_; }
  /// The arm across the travel from a representative's arm, if that is of a settled place.
  OptionalArm across(const IdentifiedArms& identified, ArmId arm) const {
    const OptionalArm to = identified.across(arm);
    return to && contains(table_.visit_of(*to)) ? to : OptionalArm();
  }

  /// Whether no two of them are joined by two travels.                  [axiom one_segment]
  bool are_joined_once(const IdentifiedArms& identified) const;
  /// Whether no two paths meet at two of them. They would do so in every map to come: they cannot
  /// turn out to be one path, since no path comes to a place twice.     [axiom one_crossing]
  bool paths_cross_once(const IdentifiedArms& identified) const;

 private:
  const ArmTable& table_;
  IdVector<VisitId, bool> is_settled_;
  std::vector<VisitId> visits_;
  std::vector<std::uint64_t> arms_;
};

}  // namespace asterism
