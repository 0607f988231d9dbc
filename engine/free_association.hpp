#pragma once

#include <z3++.h>

#include <map>
#include <utility>
#include <vector>

#include "engine/arm_table.hpp"

namespace asterism {

/// Data association left to the solver: which visits are told of, and where each was.  [DESIGN §8]
///
/// at(k, a): visit k came in by arm a of the place of an earlier visit, which was new there; or,
/// with the arm of its own star that it says, its place is new. Of a visit told of, exactly one
/// holds; of another none, so that its star and both its travels are as if they had not been.
///
/// What is asked for is defined in the solver when first asked for.
class FreeAssociation {
 public:
  FreeAssociation(z3::context& context, z3::solver& solver, const ArmTable& table);

  const ArmTable& table() const { return table_; }
  z3::context& context() const { return context_; }

  z3::expr told(std::size_t k) const { return told_[k]; }
  /// @param arm  one of an earlier visit, or the one visit k was entered by
  z3::expr at(std::size_t k, ArmIndex arm) const;
  z3::expr is_new(std::size_t k) const { return at_[k].back(); }
  /// Has the solver choose exactly one for a visit told of. To be called once, for each such visit.
  void choose(std::size_t k);
  /// The arms that visit k may have come in by.
  std::vector<ArmIndex> choices(std::size_t k) const;

  /// Both are told of and were at one place.
  z3::expr same(std::size_t i, std::size_t j);
  /// An arm of a visit's own star, as that visit counts them.
  struct OwnArm {
    std::size_t visit;
    std::size_t arm;
  };
  /// Both are told of, and these are one arm of one place.
  z3::expr coincide(OwnArm one, OwnArm other);
  /// True if a travel joins these gateways, in either direction; else free.
  z3::expr linked(ArmIndex one, ArmIndex other);
  /// "There are at least so many places", paths, segments, by the closed form.          [DESIGN §6]
  z3::expr at_least_places(std::size_t count);
  z3::expr at_least_paths(std::size_t count);
  z3::expr at_least_segments(std::size_t count);

  /// The arm that each visit came in by in a model; none where it is not told of.
  static constexpr ArmIndex untold = UINT32_MAX;
  std::vector<ArmIndex> named(const z3::model& model) const;

 private:
  z3::expr here(std::size_t k, std::size_t first_visit) const;
  const std::vector<z3::expr>& has_segment();
  z3::expr at_most(const std::vector<std::pair<z3::expr, int>>& sum, int bound);

  z3::context& context_;
  z3::solver& solver_;
  const ArmTable& table_;
  std::vector<z3::expr> told_;
  std::vector<std::vector<z3::expr>> at_;  ///< of visit k: an earlier arm each, the new place last
  std::map<std::pair<std::size_t, std::size_t>, z3::expr> same_;
  std::map<std::pair<ArmIndex, ArmIndex>, z3::expr> linked_;
  std::vector<z3::expr> has_segment_;  ///< one a gateway that may get a segment
};

}  // namespace asterism
