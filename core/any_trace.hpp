#pragma once

#include <variant>

#include "core/experience.hpp"
#include "core/trace.hpp"

namespace asterism {

/// A trace of either kind: visits, or views and actions of the basic SSH.
using AnyTrace = std::variant<Trace, Experience>;

}  // namespace asterism
