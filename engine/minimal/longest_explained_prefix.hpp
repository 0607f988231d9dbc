#pragma once

#include <cstddef>
#include <optional>

#include "core/trace.hpp"
#include "engine/minimal/minimal_search.hpp"

namespace asterism {

/// How many visits of a trace, from the first, some map explains: all of them, or those before the
/// first that none explains, which the search for minimal models alone does not tell.
///
/// @return nothing if it is to stop
std::optional<std::size_t> longest_explained_prefix(const Trace& trace,
                                                    const MinimalSearch::Options& options,
                                                    const Stop& stop = {});

}  // namespace asterism
