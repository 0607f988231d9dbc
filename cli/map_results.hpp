#pragma once

#include <cstddef>
#include <span>

#include "axioms/axiom_set.hpp"
#include "cli/options.hpp"
#include "core/map_report.hpp"
#include "io/maps_file.hpp"

namespace asterism {

// Where the findings of `asterism map` go.

inline constexpr std::size_t most_maps_in_text = 20;
inline constexpr std::size_t most_drawings = 100;

/// Prints the report, or writes it as a maps file, as the command asks.
/// @param report  its maps are those to spell out
/// @param maps    those of the file
void write_report(const MapCommand& command, const MapReport& report, const MapSource& maps);

/// Draws the first of the best maps into the command's folder.
/// @param number  how many there are
void write_models(const MapCommand& command, const MapReport& report,
                  std::span<const TopologicalMap> models, std::size_t number);

/// Writes the grounded problem of each map, if the command asks for that.
void write_problems(const MapCommand& command, const AxiomSet& axioms, const Trace& trace,
                    const MapSource& maps);

}  // namespace asterism
