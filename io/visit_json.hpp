#pragma once

#include "core/trace.hpp"
#include "io/json_node.hpp"

namespace asterism {

/// One visit of a trace, by itself: what the visits before and after it demand is not checked.
/// @throws InputError as read_trace
Visit read_visit(const JsonNode& node);

}  // namespace asterism
