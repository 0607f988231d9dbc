#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "axioms/theory.hpp"
#include "core/map_report.hpp"
#include "core/stop.hpp"
#include "core/trace.hpp"

namespace asterism {

/// The end of the longest part of a trace, from a visit on, that is explained: the first visit that
/// is not, or the number of visits. Nothing where that is not to be known.
using ExplainedUntil = std::function<std::optional<std::size_t>(std::size_t first)>;

/// Where to cut a trace so that each part is explained: as few times as can be; of such ways that
/// with the greatest sum of squares of the parts' lengths, so that one part has most of the visits;
/// of these that with the longest first part, and so on.
///
/// @param explained_until  of a later visit it is no less, since what explains a part explains
///                         each part of it
/// @return  the visits before which it is cut, in order; nothing where that is not to be known
std::optional<std::vector<std::size_t>> fewest_cuts(std::size_t visits,
                                                    const ExplainedUntil& explained_until);

/// The same of a trace and the maps of its parts: what is assumed of two visits in one part holds
/// there. Nothing, too, if the time is over, or where visits that are assumed to be at one place
/// come into two parts.
std::optional<std::vector<std::size_t>> cuts_of(const Trace& trace, const Theory& theory,
                                                const MapOptions& options, const Stop& stop = {});

/// What is asked of the maps of visits `first` to before `last`, these numbered from 0.
Theory theory_of_part(const Theory& theory, std::size_t first, std::size_t last);

}  // namespace asterism
