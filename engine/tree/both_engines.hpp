#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/id.hpp"
#include "core/stop.hpp"
#include "core/verdict.hpp"
#include "engine/tree/forced_run.hpp"
#include "engine/tree/map_tree.hpp"

namespace asterism {

/// Native engine and solver side by side, compared at every candidate.                [theory §8]
template <class Native, class Solver>
class BothEngines {
 public:
  using Choice = typename Native::Choice;
  static constexpr std::uint64_t children_between_questions = Solver::children_between_questions;

  BothEngines(Native native, Solver solver)
      : native_(std::move(native)), solver_(std::move(solver)) {}

  void reset(const Stop& stop) {
    native_.reset(stop);
    solver_.reset(stop);
  }
  /// @throws DifferenceError if the solver would keep other children
  template <class F>
  void for_each_child(VisitId k, F&& f) {
    std::vector<Choice> children;
    native_.for_each_child(k, [&](Choice choice, auto) { children.push_back(choice); });
    for (const Choice choice : solver_.candidates(k)) {
      const bool native = std::ranges::find(children, choice) != children.end();
      const Verdict verdict = solver_.decide(choice);
      if (verdict != Verdict::undecided && native != (verdict == Verdict::consistent))
        throw DifferenceError(solver_.words(k, choice), native, solver_.up_to(k));
    }
    for (const Choice choice : children) f(choice, native_.step(k, choice));
  }
  auto step(VisitId k, Choice choice) { return native_.step(k, choice); }
  ForcedRun follow(VisitId k, Choice, auto) const { return {k.next(), true}; }
  Choice arrived(VisitId k) const { return solver_.arrived(k); }
  void enter(VisitId k, Choice choice, auto step) {
    native_.enter(k, choice, step);
    solver_.enter(k, choice, step);
  }
  void leave(VisitId k, Choice choice, auto step) {
    solver_.leave(k, choice, step);
    native_.leave(k, choice, step);
  }
  auto extents_after(VisitId k, Choice choice, auto step) const {
    return native_.extents_after(k, choice, step);
  }
  std::uint64_t undecided() const { return solver_.undecided(); }
  auto named() const { return solver_.named(); }

 private:
  Native native_;
  Solver solver_;
};

}  // namespace asterism
