#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/assumption.hpp"
#include "io/json_node.hpp"

namespace asterism {

/// What is assumed, as files list it: "same(3, 9)", "differ(2, 5)".
std::vector<std::string> assumption_texts(std::span<const Assumption> assumptions);

/// Reads such a list, which must be written as above, to the space, and not be empty.
/// @throws InputError
std::vector<Assumption> read_assumptions(const JsonNode& node);

}  // namespace asterism
