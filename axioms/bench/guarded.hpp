#pragma once

#include <z3++.h>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace asterism {

/// Formulas behind a guard each, so that a solver can tell which of them cannot be together. They
/// are numbered from 0 in the order in which they are added.
class GuardedFormulas {
 public:
  /// Numbers of formulas, in order.
  using Numbers = std::vector<std::size_t>;

  explicit GuardedFormulas(z3::context& context) : context_(context) {}

  /// Adds one that holds whichever formulas are asked about.
  void grant(const z3::expr& formula) { granted_.push_back(formula); }
  /// Adds one that can be taken or left.
  void add(const z3::expr& formula) { formulas_.push_back(formula); }
  /// How many can be taken or left.
  std::size_t size() const { return formulas_.size(); }

  /// Those of `members` with which a solver of their own refutes them; nothing if it does not.
  std::optional<Numbers> core(std::span<const std::size_t> members, unsigned timeout_ms) const;

  /// Formulas that cannot be together, none of which can be spared: Z3's cores are not as small as
  /// that. To be put to confirm() of the problem made anew.
  /// @param timeout_ms  for each question
  /// @return  nothing if all can be together, or the solver did not say
  std::optional<Numbers> irredundant_core(unsigned timeout_ms) const;

  /// Checks that these cannot be together.
  /// @throws SolverError if they can be, or the solver did not say
  void confirm(std::span<const std::size_t> members, unsigned timeout_ms) const;

 private:
  z3::context& context_;
  std::vector<z3::expr> granted_;
  std::vector<z3::expr> formulas_;
};

}  // namespace asterism
