#pragma once

#include <span>
#include <vector>

#include "engine/ask/query.hpp"
#include "engine/proof/free_association.hpp"

namespace asterism {

/// Claims about maps as formulas over a data association that is left to the solver.
///
/// A statement about visits that are not told of is free: it may hold or not. Paths are counted by
/// the closed form: see require_countable().
class ClaimCircuit {
 public:
  ClaimCircuit(FreeAssociation& association, z3::solver& solver)
      : association_(association), solver_(solver) {}

  z3::expr formula(const Claim& claim);

 private:
  using OwnArm = FreeAssociation::OwnArm;
  struct Before {
    std::size_t travel;
    z3::expr meet;  ///< it leads to where this one begins
  };
  using Reached = std::vector<z3::expr>;  ///< of each travel, forwards, then backwards

  std::size_t visits() const { return association_.table().visits(); }
  const Visit& visit(VisitId k) const { return association_.table().trace().visits[k.index()]; }
  z3::expr any(const std::vector<z3::expr>& parts) const;
  z3::expr named(const z3::expr& formula);
  z3::expr free_unless_told(const std::vector<VisitId>& visits, const z3::expr& statement);

  z3::expr adjacent(VisitId i, VisitId j);
  std::vector<z3::expr> within_steps(VisitId from, std::size_t steps);
  z3::expr is_at_least(const Claim::Number& number, std::uint64_t bound);
  std::uint64_t most(const Claim::Number& number) const;
  z3::expr is_less(const Claim::Number& one, const Claim::Number& other);
  z3::expr comparison(const Claim::Comparison& comparison);

  OwnArm left_end(VisitId to) const;
  OwnArm entered_end(VisitId to) const;
  OwnArm opposite(OwnArm own) const;
  OwnArm from(std::size_t node) const;
  OwnArm to(std::size_t node) const;
  const std::vector<std::vector<Before>>& before();
  Reached along(std::span<const OwnArm> starts);
  z3::expr comes_by(const Reached& reached, VisitId visit);
  z3::expr on(VisitId visit, VisitId path_of);
  z3::expr on_path(VisitId i, VisitId j);
  z3::expr order(VisitId i, VisitId j, VisitId k);
  z3::expr same_path(VisitId i, VisitId j);

  FreeAssociation& association_;
  z3::solver& solver_;
  std::size_t statements_ = 0;
  std::size_t names_ = 0;
  std::vector<std::vector<Before>> before_;
};

}  // namespace asterism
