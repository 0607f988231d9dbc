#pragma once

#include "core/map_report.hpp"
#include "core/stop.hpp"
#include "core/trace.hpp"
#include "engine/minimal/minimal_search.hpp"
#include "mapping/checkpointing.hpp"

namespace asterism {

/// Searches for the minimal models of a trace, to the end or until it must stop, and says what is
/// known then: all but the models, of which there may be millions, and their certificate.
///
/// @param search      extended by the trace already
/// @param options     what the report says was asked
/// @param checkpoint  keeps where the search stands, if there is one
/// @throws InputError, Error  as Checkpointing::run
MapReport find_minimal(MinimalSearch& search, const Trace& trace, const MapOptions& options,
                       const Stop& stop = {}, Checkpointing* checkpoint = nullptr);

}  // namespace asterism
