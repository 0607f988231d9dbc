#pragma once

#include <string>
#include <vector>

#include "io/json/json_value.hpp"

namespace asterism {

/// Where one JSON value is not another, in order: "/json/pointer: found ...; expected ...", a line
/// each. Short lists of numbers and texts are compared as one; keys count, their order does not.
std::vector<std::string> differences(const JsonValue& found, const JsonValue& expected);

}  // namespace asterism
