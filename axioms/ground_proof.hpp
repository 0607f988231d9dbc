#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "axioms/axiom_set.hpp"

namespace asterism {

/// An axiom with a term for each of its variables.
struct AxiomInstance {
  std::string axiom;
  std::vector<std::pair<std::string, std::string>> binding;  ///< variable, term
};

/// "transitive(q, r, s)": the axiom and what its variables stand for, in order.
std::string instance_text(const AxiomInstance& instance);

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
std::optional<std::vector<AxiomInstance>> ground_proof(const Axiom& sentence,
                                                       const AxiomSet& vocabulary,
                                                       std::span<const Axiom* const> axioms,
                                                       unsigned timeout_ms);

}  // namespace asterism
