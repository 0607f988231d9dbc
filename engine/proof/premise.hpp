#pragma once

#include <compare>
#include <cstddef>

namespace asterism {

/// What a question about the maps of a trace may take for granted, or leave open.
struct Premise {
  enum class Kind {
    visit,  ///< its star, the travels to it and from it, and where it was, if a candidate says so
    axiom,  ///< by position in AxiomSet::axioms()
    planarity,
    claim  ///< by the number that MapProblem::add() gave, or exclude()
  };
  Kind kind;
  std::size_t number = 0;
  friend auto operator<=>(const Premise&, const Premise&) = default;
};

}  // namespace asterism
