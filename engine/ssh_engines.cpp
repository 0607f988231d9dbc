#include "engine/ssh_engines.hpp"

#include <algorithm>
#include <numeric>
#include <string>

namespace asterism {

void SshNative::reset() {
  named_.clear();
  views_.clear();
}

std::vector<SshNative::DState> SshNative::candidates() const {
  const std::size_t k = named_.size();
  std::vector<DState> result;
  if (k > 0)
    if (const auto known = levels_[k - 1].result(named_.back(), table_.action(k - 1))) {
      if (views_[*known] == table_.view(k)) result.push_back(*known);
      return result;
    }
  for (DState dstate = 0; dstate < views_.size(); ++dstate)
    if (views_[dstate] == table_.view(k)) result.push_back(dstate);
  result.push_back(static_cast<DState>(views_.size()));
  return result;
}

bool SshNative::try_enter(DState dstate) {
  const std::size_t k = named_.size();
  SshClosure& closure = levels_[k];
  closure = k == 0 ? empty_ : levels_[k - 1];
  const bool is_new = dstate == closure.size();
  if (is_new) closure.add_dstate();
  if (k > 0 && !closure.add_result(named_.back(), table_.action(k - 1), dstate)) return false;
  if (is_new) views_.push_back(table_.view(k));
  named_.push_back(dstate);
  return true;
}

void SshNative::leave() {
  const DState last = named_.back();
  named_.pop_back();
  if (std::ranges::find(named_, last) == named_.end()) views_.pop_back();
}

void SshSolver::reset() {
  named_.clear();
  solver_ = AxiomSolver(axioms_, timeout_ms_);
  solver_.add(table_.general_facts());
}

std::vector<SshSolver::DState> SshSolver::candidates() const {
  std::vector<DState> result(first_views(named_).size() + 1);
  std::iota(result.begin(), result.end(), DState{0});
  return result;
}

Verdict SshSolver::enter(DState dstate) {
  named_.push_back(dstate);
  solver_.push();
  solver_.add(table_.step_facts(named_));
  const Verdict verdict = solver_.check();
  if (verdict == Verdict::undecided) ++undecided_;
  return verdict;
}

bool SshSolver::try_enter(DState dstate) {
  if (enter(dstate) != Verdict::inconsistent) return true;
  leave();
  return false;
}

void SshSolver::leave() {
  named_.pop_back();
  solver_.pop();
}

void SshBoth::reset() {
  native_.reset();
  solver_.reset();
}

bool SshBoth::try_enter(DState dstate) {
  const std::vector<DState> possible = native_.candidates();
  const bool native =
      std::ranges::find(possible, dstate) != possible.end() && native_.try_enter(dstate);
  const Verdict verdict = solver_.enter(dstate);
  if (verdict != Verdict::undecided && native != (verdict == Verdict::consistent)) {
    const std::size_t k = solver_.named().size() - 1;
    Experience shortest = table_.experience();
    shortest.views.resize(k + 1);
    shortest.actions.resize(k);
    throw SshDifferenceError("native and solver differ: view " + std::to_string(k) + " at dstate " +
                                 std::to_string(dstate) + " is " +
                                 (native ? "consistent" : "inconsistent") +
                                 " to the native engine and " +
                                 (native ? "inconsistent" : "consistent") + " to the solver",
                             std::move(shortest));
  }
  if (!native) solver_.leave();
  return native;
}

void SshBoth::leave() {
  solver_.leave();
  native_.leave();
}

}  // namespace asterism
