#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "cli/text/map_text.hpp"
#include "core/map_report.hpp"
#include "io/atomic_file.hpp"
#include "io/json/maps_file.hpp"

namespace asterism {

// Where the findings of `asterism map` go.

inline constexpr std::size_t most_maps_in_text = 20;
inline constexpr std::size_t most_drawings = 100;

/// Prints the report, and writes it as a maps file, if there is one; "-": that alone, on stdout.
/// @param report  its maps are those to spell out
/// @param steps   visits, or views
/// @param maps    those of the file
template <class Report, class Map>
void write_report(const std::optional<std::string>& json, const Report& report, std::size_t steps,
                  const SourceOf<Map>& maps) {
  if (json == "-") return write_maps(std::cout, report, maps);
  if (json) write_atomically(*json, [&](std::ostream& out) { write_maps(out, report, maps); });
  fmt::print("{}", report_text(report, steps, most_maps_in_text));
}

/// Draws the first of the best maps into a folder.
/// @param number  how many there are
template <class Map>
void write_models(const std::string& svg_folder, const Findings& report,
                  const std::vector<Map>& models, std::size_t number);

/// Writes the grounded problem of a hypothesis, as SMT-LIB 2.
void write_problem(const std::filesystem::path& folder, const std::string& name,
                   const std::string& problem);

/// Writes that of each map.
/// @param problem_text  of a map
template <class Map>
void write_problems(const std::string& folder, const SourceOf<Map>& maps, auto problem_text) {
  std::size_t i = 0;
  maps([&](const Map& map) {
    write_problem(folder, fmt::format("map-{}.smt2", i++), problem_text(map));
  });
  remove_from(folder, "map-{}.smt2", i);
}

}  // namespace asterism
