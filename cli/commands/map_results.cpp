#include "cli/commands/map_results.hpp"

#include <algorithm>

#include "drawing/plane_drawing.hpp"
#include "drawing/straight_drawing.hpp"
#include "engine/ssh/ssh_tree.hpp"
#include "io/picture/map_svg.hpp"
#include "io/picture/ssh_map_svg.hpp"

namespace asterism {
namespace {

std::string drawn(const TopologicalMap& map, const std::string& title) {
  return map_svg(map, draw(map), title);
}

std::string drawn(const SshMap& map, const std::string& title) {
  return ssh_map_svg(map, draw_straight(map.number_of_places(), edges_of(map)).vertices, title);
}

}  // namespace

template <class Map>
void write_models(const std::string& svg_folder, const Findings& report,
                  const std::vector<Map>& models, std::size_t number) {
  const std::filesystem::path folder(svg_folder);
  make_folder(folder);
  const std::size_t drawings = std::min(models.size(), most_drawings);
  const std::string kind = report.bounds ? "map" : "minimal model";
  for (std::size_t i = 0; i < drawings; ++i)
    write_atomically((folder / fmt::format("model-{}.svg", i)).string(),
                     drawn(models[i], fmt::format("{}, {}{} {} (of {})", report.trace,
                                                  report.options.theory.planar ? "planar " : "",
                                                  kind, i, number)));
  remove_from(folder, "model-{}.svg", drawings);
  if (drawings < number)
    fmt::print(stderr, "drew the first {} of {} {}s\n", drawings, number, kind);
}

template void write_models(const std::string&, const Findings&, const std::vector<TopologicalMap>&,
                           std::size_t);
template void write_models(const std::string&, const Findings&, const std::vector<SshMap>&,
                           std::size_t);

void write_problem(const std::filesystem::path& folder, const std::string& name,
                   const std::string& problem) {
  make_folder(folder);
  write_atomically((folder / name).string(), problem);
}

}  // namespace asterism
