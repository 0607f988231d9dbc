#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "core/trace.hpp"
#include "engine/minimal_search.hpp"

namespace asterism {

/// How many visits of a trace, from the first, some map explains: all of them, or those before the
/// first that none explains, which the search for minimal models alone does not tell.
///
/// @param go_on  as in MinimalSearch::run
/// @return nothing if it said to stop
std::optional<std::size_t> explained_visits(
    const Trace& trace, const MinimalSearch::Options& options,
    const std::function<bool(const MinimalSearch&)>& go_on = {});

}  // namespace asterism
