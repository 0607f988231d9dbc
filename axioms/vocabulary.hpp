#pragma once

#include <map>
#include <optional>
#include <string>

#include "axioms/axiom_set.hpp"

namespace asterism {

/// What may not be called so: no name of letters, digits and _, or a word of SMT-LIB itself.
/// @return what was expected instead; nothing if the name will do
std::optional<std::string> fault_of_name(const std::string& name);

/// Whether constants of facts are called so: d3_1 is a dstate, v2 a view, a4 an action.
bool is_name_of_fact(const std::string& name);

/// A set must declare what facts are told in, whatever it says about it: leads, sees, is_turn,
/// next, opposite, ends, the actions travel, turn_around and turn_clockwise, and place and along.
/// Dstates, actions and views are named apart, so no function may make them.
/// @param where  file or folder, for messages
/// @throws InputError with the declaration that is missing
void require_vocabulary(const std::map<std::string, AxiomSet::Function>& functions,
                        const std::string& where);

}  // namespace asterism
