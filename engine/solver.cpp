#include "engine/solver.hpp"

#include <algorithm>

#include "engine/facts.hpp"
#include "planarity/euler.hpp"

namespace asterism {

void SolverEngine::reset() {
  named_.clear();
  solver_ = AxiomSolver(axioms_, timeout_ms_);
  solver_.add(general_facts());
}

std::vector<ArmIndex> SolverEngine::candidates(std::size_t k) const {
  std::vector<ArmIndex> result;
  for (std::size_t j = 0; j < k; ++j) {
    if (table_.visit_of(named_[j]) != j) continue;
    for (ArmIndex i = 0; i < table_.star_size(j); ++i) result.push_back(table_.first_arm(j) + i);
  }
  result.push_back(table_.entered(k));
  return result;
}

Verdict SolverEngine::decide(ArmIndex arm) {
  const std::size_t k = named_.size();
  enter(k, arm, step(k, arm));
  Verdict verdict = solver_.check();
  leave(k, arm, step(k, arm));
  if (verdict != Verdict::inconsistent && planar_ && part_not_planar(map_with(arm)))
    verdict = Verdict::inconsistent;
  if (verdict == Verdict::undecided) ++undecided_;
  return verdict;
}

void SolverEngine::enter(std::size_t, ArmIndex arm, Step) {
  named_.push_back(arm);
  solver_.push();
  solver_.add(visit_facts(table_, named_));
}

void SolverEngine::leave(std::size_t, ArmIndex, Step) {
  named_.pop_back();
  solver_.pop();
}

TopologicalMap SolverEngine::map_with(ArmIndex arm) const {
  std::vector<ArmIndex> named = named_;
  named.push_back(arm);
  return make_map(table_.trace(), table_.arrivals(named));
}

Extents SolverEngine::extents_after(std::size_t, ArmIndex arm, Step) const {
  return extents_of(map_with(arm));
}

void BothEngines::compare(std::size_t k, std::vector<ArmIndex> native_children) {
  std::sort(native_children.begin(), native_children.end());
  for (const ArmIndex arm : solver_.candidates(k)) {
    const bool native = std::binary_search(native_children.begin(), native_children.end(), arm);
    const Verdict verdict = solver_.decide(arm);
    if (verdict == Verdict::undecided || native == (verdict == Verdict::consistent)) continue;
    Trace shortest = table_.trace();
    shortest.visits.erase(shortest.visits.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                          shortest.visits.end());
    const ArmIndex place = table_.visit_of(arm);
    throw DifferenceError(
        "native and solver differ: visit " + std::to_string(k) +
            (place == k ? " at a new place" : " at the place of visit " + std::to_string(place)) +
            " by its arm " + std::to_string(arm - table_.first_arm(place)) + " is " +
            (native ? "consistent" : "inconsistent") + " to the native engine and " +
            (native ? "inconsistent" : "consistent") + " to the solver",
        std::move(shortest));
  }
}

}  // namespace asterism
