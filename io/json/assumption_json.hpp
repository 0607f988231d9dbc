#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/assumption.hpp"
#include "io/json/json_node.hpp"
#include "io/json/json_writer.hpp"

namespace asterism {

/// What is assumed, as files list it: "same(3, 9)", "differ(2, 5)".
std::vector<std::string> assumption_texts(std::span<const Assumption> assumptions);

/// Writes the member "assumptions" of an object, unless there are none.
void write_assumptions(JsonWriter& json, std::span<const Assumption> assumptions);

/// Reads a list of assumptions, which must be written as assumption_texts does, to the space, and
/// not be empty; none where there is no list.  @throws InputError
std::vector<Assumption> read_assumptions(const JsonNode& node);

}  // namespace asterism
