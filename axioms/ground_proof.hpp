#pragma once

#include <optional>
#include <span>
#include <vector>

#include "axioms/axiom_set.hpp"
#include "axioms/axiom_solver.hpp"

namespace asterism {

/// Why a sentence follows from axioms: instances of them that cannot hold together where it fails,
/// none of which can be spared; found by Z3, and checked again by a fresh solver.
///
/// The variables of the sentence become constants, which may be equal, beside those declared; the
/// axioms are written out for these, and variables of sorts that functions make also for terms of
/// up to two functions.
///
/// @param axioms  what the sentence follows from; none said by the signature
/// @return  nothing if no proof was found: it does not follow, there is too much to write out, or
///          Z3 did not say in time
std::optional<std::vector<Clash::Step>> ground_proof(const Axiom& sentence,
                                                     const AxiomSet& vocabulary,
                                                     std::span<const Axiom* const> axioms,
                                                     unsigned timeout_ms);

}  // namespace asterism
