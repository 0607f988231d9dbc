#include "cli/map_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "cli/map_parts.hpp"
#include "cli/map_text.hpp"
#include "io/atomic_file.hpp"
#include "io/map_svg.hpp"
#include "planarity/plane_drawing.hpp"

namespace asterism {

void write_report(const MapCommand& command, const MapReport& report, const MapSource& maps) {
  if (command.json == "-") return write_maps(std::cout, report, maps);
  if (command.json)
    write_atomically(*command.json, [&](std::ostream& out) { write_maps(out, report, maps); });
  fmt::print("{}", report_text(report, command.visits, most_maps_in_text));
}

void write_models(const MapCommand& command, const MapReport& report,
                  std::span<const TopologicalMap> models, std::size_t number) {
  const std::filesystem::path folder(*command.svg_folder);
  make_folder(folder);
  const std::size_t drawings = std::min(models.size(), most_drawings);
  const std::string kind = fmt::format("{}{}", report.options.planar ? "planar " : "",
                                       report.bounds ? "map" : "minimal model");
  for (std::size_t i = 0; i < drawings; ++i)
    write_atomically((folder / fmt::format("model-{}.svg", i)).string(),
                     map_svg(models[i], draw(models[i]),
                             fmt::format("{}, {} {} (of {})", report.trace, kind, i, number)));
  remove_from(folder, "model-{}.svg", drawings);
  if (drawings < number)
    fmt::print(stderr, "drew the first {} of {} {}s\n", drawings, number,
               report.bounds ? "map" : "minimal model");
}

void write_problems(const MapCommand& command, const AxiomSet& axioms, const Trace& trace,
                    const MapSource& maps) {
  if (!command.smt2_folder) return;
  std::size_t i = 0;
  maps([&](const TopologicalMap& map) {
    write_problem(*command.smt2_folder, fmt::format("map-{}.smt2", i++), trace, arrivals(map),
                  axioms);
  });
  remove_from(*command.smt2_folder, "map-{}.smt2", i);
}

}  // namespace asterism
