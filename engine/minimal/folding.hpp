#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/assumption.hpp"
#include "core/stop.hpp"
#include "core/verdict.hpp"
#include "engine/arm_table.hpp"
#include "engine/minimal/identified_arms.hpp"
#include "engine/minimal/settled_faces.hpp"
#include "engine/minimal/settled_places.hpp"
#include "engine/minimal/stamped_set.hpp"
#include "engine/tree/native_engine.hpp"

namespace asterism {

/// A trace as one big map, folded wherever two of its visits turn out to have been to one place.
///
/// Begins with a place for each visit, each joined to the next. To *identify* two arms makes their
/// places one, star on star, and what follows: a gateway that both places left leads to one arm, so
/// those two are identified as well, however much later in the trace they were seen (deterministic,
/// reversible). Where that meets a contradiction, no map has the two arms one.
///
/// A *settled* place differs from all others that are settled; a map is a folding all of whose
/// places are settled. Every step is undone in reverse order. A copy is for another thread.
class Folding {
 public:
  /// How much has been done; by default, nothing since the folding was begun.
  struct Mark {
    IdentifiedArms::Mark identified = 0;
    SettledPlaces::Mark settled = 0;
  };

  /// @param table  of the trace; must outlive it
  Folding(const ArmTable& table, NativeEngine::Rules rules);

  /// Folds the trace as its travels alone demand, and finds for every two visits and arms whether
  /// they can be one.
  /// @param before  of fewer visits of the trace and no more assumptions, nothing settled: what is
  ///                known from there; may be null
  /// @param stop    asked every few milliseconds
  /// @return inconsistent if the trace, or what is assumed, contradicts itself; undecided if
  ///         it is to stop: to be begun again
  Verdict begin(std::span<const Assumption> assumptions, const Folding* before, const Stop& stop);

  /// @return false at a contradiction; what was done until then is to be undone
  bool identify(ArmId x, ArmId y);
  /// The place of this arm differs from all that are settled.
  /// @return false at a contradiction, also if it is settled
  bool settle(ArmId arm);

  Mark mark() const { return {arms_.mark(), settled_.mark()}; }
  void undo(Mark mark);

  /// What is one with what.
  const IdentifiedArms& arms() const { return arms_; }
  /// What differs from what.
  const SettledPlaces& settled() const { return settled_; }

  /// Calls f(y) for each arm y of settled places that may be one with x; f returns whether to go
  /// on.
  template <class F>
  void for_each_settled(ArmId x, F&& f) const {
    arms_.for_each_that_may_be(x, settled_.arms(), f);
  }
  /// Planar maps alone: numbers the faces between settled places, for the questions below.
  void number_faces();
  /// Whether the place of x, joined to settled places, can be that of y without crossing a segment
  /// of settled places.
  bool may_stand_at(ArmId x, ArmId y) const {
    return !rules_.faces || faces_.may_stand_at(x, y, arms_, settled_);
  }
  /// Whether it can be another place than all that are settled, without such a crossing.
  bool may_stand_apart(ArmId x) const {
    return !rules_.faces || faces_.may_stand_apart(x, arms_, settled_);
  }
  /// Whether some of the arms in a set, of places not settled, may be one with x, of a settled one.
  bool may_be_any(ArmId x, std::span<const std::uint64_t> arms) const;

  /// The data association, once all places are settled: the arm by which visit k was entered, as
  /// an arm of the place's first visit.
  std::vector<ArmId> named() const;

  /// Bytes held, but for those that a trace of this length always takes.
  std::size_t memory_bytes() const { return arms_.memory_bytes(); }

 private:
  bool assume(std::span<const Assumption> assumptions);
  bool join(ArmId x, ArmId y);
  bool try_all(const Stop& stop);
  bool contradicts(ArmId x, ArmId y) const;
  bool go_on_identifying();
  bool differ_as_assumed() const;
  bool paths_are_lines(VisitId visit);
  bool is_line(ArmId arm);
  bool settled_places_agree();

  const ArmTable& table_;
  NativeEngine::Rules rules_;
  std::vector<std::pair<VisitId, VisitId>> same_;    ///< visits assumed to be at one place
  std::vector<std::pair<VisitId, VisitId>> differ_;  ///< visits assumed to be at two
  IdentifiedArms arms_;
  SettledPlaces settled_;
  SettledFaces faces_;
  bool faces_are_numbered_ = false;

  std::vector<std::pair<ArmId, ArmId>> to_identify_;
  std::vector<VisitId> changed_;  ///< visits, by what was identified last
  StampedSet<VisitId> on_path_;
  std::uint64_t united_ = 0;  ///< so often places became one, undone or not
};

}  // namespace asterism
