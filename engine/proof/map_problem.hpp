#pragma once

#include <memory>
#include <span>
#include <vector>

#include "axioms/theory.hpp"
#include "core/stop.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"
#include "core/verdict.hpp"
#include "engine/ask/query.hpp"
#include "engine/proof/premise.hpp"
#include "engine/proof/sketch.hpp"

namespace asterism {

/// All maps of a trace as one problem for the solver, which also finds out which visits were to the
/// same place: no star matching and no tree takes part.                              [theory §8]
///
/// While there is a solution, the axioms are grounded on the map it stands for and the instances
/// added; a map that stands all of them and is not planar, where it must be, is ruled out by the
/// fewest of its segments that cannot be drawn together.
class MapProblem {
 public:
  /// @param stop       its deadline is for all questions together
  /// @param candidate  where the visits were, up to the last it tells of, those after being none of
  ///                   the problem; empty: that is left to the solver
  MapProblem(const Trace& trace, const Theory& theory, const Stop& stop,
             std::span<const Arrival> candidate = {});
  ~MapProblem();
  MapProblem(MapProblem&&) noexcept;
  MapProblem& operator=(MapProblem&&) noexcept;

  /// @pre  the visits it names are the trace's
  Premise add(const Claim& claim);
  /// Every map but this.   @pre  places are numbered by first visit, all visits told of
  Premise exclude(std::span<const Arrival> map);
  /// The whole trace and the whole theory: all axioms but those said by the signature, planarity if
  /// it is asked for, and what is assumed.
  std::vector<Premise> premises() const;

  /// Is there a map of which all these are true? Undecided when out of time.
  Verdict check(std::span<const Premise> premises);

  /// After *inconsistent*: those of the premises that the solver used, in order.
  std::span<const Premise> core() const;
  /// After *consistent*: where each visit was, nothing where it was not told of. Places are
  /// numbered by the first visit told of.
  PartialMap map() const;
  /// After *consistent* with all visits for premises: where each was.
  std::vector<Arrival> whole_map() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace asterism
