#include "engine/ssh/ssh_engines.hpp"

#include <string>

namespace asterism {
namespace {

/// As the closure has it.
SshClosure::DState number(DStateId dstate) {
  return static_cast<SshClosure::DState>(dstate.index());
}

}  // namespace

void SshNative::reset(const Stop&) {
  named_.clear();
  views_.clear();
}

/// Where the action before view k is known to lead.
std::optional<DStateId> SshNative::known_result(VisitId k) const {
  if (k.index() == 0) return std::nullopt;
  const std::size_t before = k.previous().index();
  const auto known = levels_[before].result(number(named_.back()), table_.action(before));
  return known ? std::optional(DStateId(*known)) : std::nullopt;
}

/// Whether view k may have been seen at the dstate. If so, its level is what follows from it.
bool SshNative::holds(VisitId k, DStateId dstate) {
  SshClosure& closure = levels_[k.index()];
  closure = k.index() == 0 ? empty_ : levels_[k.previous().index()];
  if (dstate.index() == closure.size()) closure.add_dstate();
  return k.index() == 0 || closure.add_result(number(named_.back()),
                                              table_.action(k.previous().index()), number(dstate));
}

bool SshNative::step(VisitId k, DStateId dstate) {
  holds(k, dstate);
  return dstate.index() == views_.size();
}

void SshNative::enter(VisitId k, DStateId dstate, bool is_new) {
  if (is_new) views_.push_back(table_.view(k.index()));
  named_.push_back(dstate);
}

void SshNative::leave(VisitId, DStateId, bool is_new) {
  if (is_new) views_.pop_back();
  named_.pop_back();
}

void SshSolver::reset(const Stop& stop) {
  named_.clear();
  solver_.emplace(axioms_, stop.question_ms());
  solver_->add(table_.general_facts());
}

std::vector<DStateId> SshSolver::candidates(VisitId) const {
  std::vector<DStateId> result;
  for (const DStateId dstate : IdRange<DStateId>(first_views(named_).size() + 1))
    result.push_back(dstate);
  return result;
}

Verdict SshSolver::decide(DStateId dstate) {
  const VisitId k(named_.size());
  enter(k, dstate, {});
  const Verdict verdict = solver_->check();
  leave(k, dstate, {});
  if (verdict == Verdict::undecided) ++undecided_;
  return verdict;
}

void SshSolver::enter(VisitId, DStateId dstate, bool) {
  named_.push_back(dstate);
  solver_->push();
  solver_->add(table_.step_facts(named_));
}

void SshSolver::leave(VisitId, DStateId, bool) {
  named_.pop_back();
  solver_->pop();
}

std::string SshSolver::words(VisitId k, DStateId dstate) const {
  return "view " + std::to_string(k.index()) + " at dstate " + std::to_string(dstate.index());
}

Experience SshSolver::up_to(VisitId k) const {
  Experience experience = table_.experience();
  experience.views.resize(k.index() + 1);
  experience.actions.resize(k.index());
  return experience;
}

}  // namespace asterism
