#pragma once

#include <span>
#include <string>

#include "axioms/axiom_set.hpp"
#include "axioms/fact.hpp"

namespace asterism {

/// The question whether facts are consistent with the axioms as SMT-LIB 2 text without quantifiers,
/// for any solver: declarations, unique names, a named assertion a fact and an instance, check-sat.
std::string smt2_text(const AxiomSet& axioms, std::span<const Fact> facts,
                      const std::string& title);

}  // namespace asterism
