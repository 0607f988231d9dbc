#pragma once

#include <z3++.h>

#include <map>
#include <utility>
#include <vector>

#include "core/id_vector.hpp"
#include "engine/arm_table.hpp"

namespace asterism {

/// Data association left to the solver: which visits are told of, and where each was.  [theory §8]
///
/// at(k, a): visit k came in by arm a of the place of an earlier visit, which was new there; or,
/// with the arm of its own star that it says, its place is new. Of a visit told of, exactly one
/// holds; of another none, so that its star and both its travels are as if they had not been.
///
/// What is asked for is defined in the solver when first asked for.
class FreeAssociation {
 public:
  FreeAssociation(z3::context& context, z3::solver& solver, const ArmTable& table);

  /// The visits that are associated.
  const ArmTable& table() const { return table_; }
  z3::context& context() const { return context_; }

  /// Visit k is told of.
  z3::expr told(VisitId k) const { return told_[k]; }
  /// Visit k came in by this arm.
  /// @param arm  one of an earlier visit, or the one visit k was entered by
  z3::expr at(VisitId k, ArmId arm) const;
  /// The place of visit k is new.
  z3::expr is_new(VisitId k) const { return at_[k].back(); }
  /// Has the solver choose exactly one for a visit told of. To be called once, for each such visit.
  void choose(VisitId k);
  /// The arms that visit k may have come in by.
  std::vector<ArmId> choices(VisitId k) const;

  /// Visits i and j are told of and were at one place.
  z3::expr same(VisitId i, VisitId j);
  /// An arm of a visit's own star, as that visit counts them.
  struct OwnArm {
    VisitId visit;
    std::size_t arm;
  };
  /// The two visits are told of, and these are one arm of one place.
  z3::expr coincide(OwnArm one, OwnArm other);
  /// True if a travel joins these gateways, in either direction; else free.
  z3::expr linked(ArmId one, ArmId other);
  /// There are at least so many places.
  z3::expr at_least_places(std::size_t count);
  /// There are at least so many paths, by the closed form.          [theory §6]
  z3::expr at_least_paths(std::size_t count);
  /// There are at least so many segments, by the closed form.       [theory §6]
  z3::expr at_least_segments(std::size_t count);

  /// The arm that each visit came in by in a model; no_arm where it is not told of.
  std::vector<ArmId> named(const z3::model& model) const;

 private:
  z3::expr here(VisitId k, VisitId first_visit) const;
  const std::vector<z3::expr>& has_segment();
  z3::expr at_most(const std::vector<std::pair<z3::expr, int>>& sum, int bound);

  z3::context& context_;
  z3::solver& solver_;
  const ArmTable& table_;
  IdVector<VisitId, z3::expr> told_;
  IdVector<VisitId, std::vector<z3::expr>> at_;  ///< an earlier arm each, the new place last
  std::map<std::pair<VisitId, VisitId>, z3::expr> same_;
  std::map<std::pair<ArmId, ArmId>, z3::expr> linked_;
  std::vector<z3::expr> has_segment_;  ///< one a gateway that may get a segment
};

}  // namespace asterism
