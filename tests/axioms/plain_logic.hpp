#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "axioms/axiom_set.hpp"
#include "axioms/fact.hpp"
#include "core/verdict.hpp"

namespace asterism {

// The axioms and facts written out as SMT-LIB 2 in the plainest way, apart from the grounder, so
// that the answers of the library can be judged.

using Binding = std::map<std::string, std::string>;  ///< variable to term

/// Constants of each sort, those that the set declares among them.
std::map<std::string, std::set<std::string>> constants_of(const AxiomSet& axioms,
                                                          std::span<const Fact> facts);

/// Sorts, functions, constants, and which constants differ.
std::string declarations_text(const AxiomSet& axioms, std::span<const Fact> facts);

/// "(leads d0_0 travel d1_0)"
std::string fact_text(const Fact& fact);

/// One axiom with its variables bound.
std::string instance_text(const Axiom& axiom, const Binding& binding);

/// Every instance of every axiom over all constants. A variable of a sort that functions make is
/// bound to all terms with at most two functions.
std::vector<std::string> every_instance(const AxiomSet& axioms, std::span<const Fact> facts);

/// The verdict of Z3, in a context of its own, on declarations and assertions.
Verdict verdict_of(const std::string& declarations, std::span<const std::string> assertions);

/// The verdict on facts with every instance of every axiom.
Verdict plain_verdict(const AxiomSet& axioms, std::span<const Fact> facts);

}  // namespace asterism
