#include "engine/tree/solver_engine.hpp"

#include "engine/facts.hpp"
#include "engine/preference.hpp"
#include "planarity/euler.hpp"

namespace asterism {

void SolverEngine::reset(const Stop& stop) {
  named_.clear();
  solver_.emplace(theory_.axioms, stop.question_ms());
  solver_->add(general_facts());
}

std::vector<ArmId> SolverEngine::candidates(VisitId k) const {
  std::vector<ArmId> result;
  for (const VisitId j : IdRange(VisitId(0), k))
    if (table_.visit_of(named_[j.index()]) == j)
      for (const ArmId arm : table_.arms(j)) result.push_back(arm);
  result.push_back(table_.entered(k));
  return result;
}

Verdict SolverEngine::decide(ArmId arm) {
  const VisitId k(named_.size());
  enter(k, arm, step(k, arm));
  Verdict verdict = solver_->check();
  leave(k, arm, step(k, arm));
  if (verdict != Verdict::inconsistent && theory_.planar &&
      part_not_planar(make_map(table_.trace(), table_.arrivals(named_with(arm)))))
    verdict = Verdict::inconsistent;
  if (verdict == Verdict::undecided) ++undecided_;
  return verdict;
}

void SolverEngine::enter(VisitId, ArmId arm, Step) {
  named_.push_back(arm);
  solver_->push();
  solver_->add(visit_facts(table_, named_));
}

void SolverEngine::leave(VisitId, ArmId, Step) {
  named_.pop_back();
  solver_->pop();
}

std::vector<ArmId> SolverEngine::named_with(ArmId arm) const {
  std::vector<ArmId> named = named_;
  named.push_back(arm);
  return named;
}

std::vector<std::size_t> SolverEngine::extents_after(VisitId, ArmId arm, Step) const {
  return extents_by_preference(table_, named_with(arm), theory_.axioms);
}

std::string SolverEngine::words(VisitId k, ArmId arm) const {
  const VisitId place = table_.visit_of(arm);
  return "visit " + std::to_string(k.index()) +
         (place == k ? " at a new place"
                     : " at the place of visit " + std::to_string(place.index())) +
         " by its arm " + std::to_string(table_.position(arm));
}

Trace SolverEngine::up_to(VisitId k) const {
  Trace trace = table_.trace();
  trace.visits.erase(trace.visits.begin() + static_cast<std::ptrdiff_t>(k.index()) + 1,
                     trace.visits.end());
  return trace;
}

}  // namespace asterism
