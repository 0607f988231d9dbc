#include "axioms/bench/guarded.hpp"

#include <numeric>
#include <set>
#include <string>

#include "axioms/bench/spare.hpp"
#include "axioms/bench/z3.hpp"

namespace asterism {

std::optional<GuardedFormulas::Numbers> GuardedFormulas::core(std::span<const std::size_t> members,
                                                              unsigned timeout_ms) const {
  z3::solver solver = simple_solver(context_);
  set_timeout(solver, timeout_ms);
  for (const z3::expr& formula : granted_) solver.add(formula);
  z3::expr_vector guards(context_);
  for (const std::size_t i : members) {
    const z3::expr guard = context_.bool_const(("guard_" + std::to_string(i)).c_str());
    solver.add(z3::implies(guard, formulas_[i]));
    guards.push_back(guard);
  }
  if (solver.check(guards) != z3::unsat) return std::nullopt;
  std::set<unsigned> used;
  for (const z3::expr& guard : solver.unsat_core()) used.insert(guard.id());
  Numbers result;
  for (std::size_t i = 0; i < members.size(); ++i)
    if (used.contains(guards[static_cast<int>(i)].id())) result.push_back(members[i]);
  return result;
}

std::optional<GuardedFormulas::Numbers> GuardedFormulas::irredundant_core(
    unsigned timeout_ms) const {
  Numbers all(size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const auto found = core(all, timeout_ms);
  if (!found) return std::nullopt;
  return spare_one_by_one(*found, *found, [&](const Numbers& others) {
    return core(others, timeout_ms) ? std::optional(others) : std::nullopt;
  });
}

void GuardedFormulas::confirm(std::span<const std::size_t> members, unsigned timeout_ms) const {
  if (!core(members, timeout_ms)) throw SolverError("z3: a core did not stand a second check");
}

}  // namespace asterism
