#pragma once

#include <z3++.h>

#include <functional>
#include <map>
#include <string>

#include "axioms/axiom_set.hpp"

namespace asterism {

/// Each function and relation that a set declares, by name.
std::map<std::string, z3::func_decl> declare_functions(z3::context& context,
                                                       const AxiomSet& axioms);

/// What a relation or an equality of an axiom is for Z3, its variables standing for something.
using AtomForZ3 = std::function<z3::expr(const Formula&)>;

/// A formula whose relations and equalities are what `atom` makes of them.
z3::expr z3_formula(z3::context& context, const Formula& formula, const AtomForZ3& atom);

/// premise → conclusion of an axiom.
/// @param premise  further premises, before those of the axiom
z3::expr z3_implication(z3::expr_vector premise, const Axiom& axiom, const AtomForZ3& atom);

}  // namespace asterism
