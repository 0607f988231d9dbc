#pragma once

#include <compare>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "axioms/axiom_set.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"
#include "core/verdict.hpp"
#include "engine/query.hpp"
#include "engine/sketch.hpp"

namespace asterism {

/// What a question about the maps of a trace may take for granted, or leave open.
struct Premise {
  enum class Kind {
    visit,  ///< its star, and the travels to it and from it
    axiom,  ///< by position in AxiomSet::axioms()
    planarity,
    claim  ///< by the number that add() gave
  };
  Kind kind;
  std::size_t number = 0;
  friend auto operator<=>(const Premise&, const Premise&) = default;
};

/// All maps of a trace as one problem for the solver, which also finds out which visits were to the
/// same place: no star matching and no tree takes part.                              [DESIGN §8]
///
/// While there is a solution, the axioms are grounded on the map it stands for and the instances
/// added; a map that stands all of them and is not planar, where it must be, is ruled out by the
/// fewest of its segments that cannot be drawn together.
class MapProblem {
 public:
  /// @param seconds  for all questions together
  MapProblem(const Trace& trace, const AxiomSet& axioms, double seconds);
  ~MapProblem();
  MapProblem(MapProblem&&) noexcept;
  MapProblem& operator=(MapProblem&&) noexcept;

  /// @pre  the visits it names are the trace's
  Premise add(const Claim& claim);
  /// The whole trace and all axioms but those said by the signature; planarity too if asked for.
  std::vector<Premise> premises(bool planar) const;

  /// Is there a map of which all these are true? Undecided when out of time.
  Verdict check(std::span<const Premise> premises);

  /// After *inconsistent*: those of the premises that the solver used, in order.
  std::span<const Premise> core() const;
  /// After *consistent*: where each visit was, nothing where it was not told of. Places are
  /// numbered by the first visit told of.
  PartialMap map() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace asterism
