#pragma once

#include <vector>

#include "axioms/axiom_set.hpp"

namespace asterism {

// Sentences that are no axioms, for asking what axioms leave open: in the words of a set, but not
// always of the form that axioms must have.

/// Turning around and turning clockwise are turns: told with every trace, whatever it is.
Axiom turns_are_turns(const AxiomSet& axioms);

/// No travel leads from one place to another.
Axiom no_travel_between_places(const AxiomSet& axioms);

/// What is so wherever a robot may be, though no axiom needs to say it: an action leads to another
/// dstate, as do next and opposite, travel is no turn, and where there is `opp`, each directed path
/// has another one as its opposite, and is the opposite of that.
std::vector<Axiom> usual_sentences(const AxiomSet& axioms);

}  // namespace asterism
