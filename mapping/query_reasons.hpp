#pragma once

#include "axioms/theory.hpp"
#include "core/stop.hpp"
#include "core/trace.hpp"
#include "engine/ask/query.hpp"
#include "io/json/explanation_json.hpp"

namespace asterism {

/// Why a query is impossible or certain in the maps of a trace, or two maps that differ in it.
///
/// All maps are asked first: premises clash, or there is a map of either kind. Where the minimal
/// models alone are asked for, preference is the next reason: none of them makes the query true, or
/// none makes it false.
///
/// @param only_minimal  the minimal models are asked, not all maps
/// @param jobs          threads of the search for these
/// @param stop          its deadline is for all of it; past it the modality is absent
ExplainReport explain_query(const Trace& trace, const Theory& theory, const Query& query,
                            bool only_minimal = false, unsigned jobs = 1, const Stop& stop = {});

}  // namespace asterism
