#include "cli/run_files.hpp"

#include <cmath>
#include <cstdint>
#include <system_error>

#include "cli/map_parts.hpp"
#include "io/atomic_file.hpp"
#include "io/map_graph.hpp"
#include "io/occupancy_map.hpp"
#include "io/png_image.hpp"
#include "io/pose_graph_file.hpp"
#include "io/route_graph.hpp"
#include "io/trajectory_file.hpp"

namespace asterism {
namespace {

// White is free, black is a wall, the unknown in between: shades where it is not certain.
PngImage picture(const Grid& grid) {
  PngImage image{
      static_cast<std::size_t>(grid.width), static_cast<std::size_t>(grid.height), 1, {}};
  image.bytes.reserve(grid.log_odds.size());
  for (int row = grid.height - 1; row >= 0; --row) {
    for (int column = 0; column < grid.width; ++column) {
      const float log_odds = grid.log_odds[grid.index({column, row})];
      const double occupied = 1 / (1 + std::exp(-static_cast<double>(log_odds)));
      image.bytes.push_back(
          static_cast<std::uint8_t>(log_odds == 0 ? 205 : std::lround(254 * (1 - occupied))));
    }
  }
  return image;
}

}  // namespace

void write_model(const std::filesystem::path& folder, const DrawnModel& model) {
  make_folder(folder);
  const auto file = [&](const char* name) { return (folder / name).string(); };
  const RankedMap& ranked = model.ranked;
  write_trajectory_file(file("trajectory.tum"), model.trajectory);
  write_occupancy_map_file(file("map.yaml"), model.global_map);
  write_png_file(file("map.png"), picture(model.global_map));
  write_pose_graph_file(file("layout.g2o"),
                        {ranked.layout.layout_from_place, ranked.displacements, {PlaceId(0)}});
  write_atomically(file("map.graphml"), map_graphml(ranked.map, ranked.layout.layout_from_place));
  write_atomically(file("map.dot"), map_dot(ranked.map, ranked.layout.layout_from_place));
  if (!ranked.map.segments.empty())
    write_atomically(file("routes.geojson"),
                     route_graph_geojson(ranked.map, ranked.layout.layout_from_place));
}

void remove_model(const std::filesystem::path& folder) {
  for (const char* name : {"trajectory.tum", "map.pgm", "map.yaml", "map.png", "layout.g2o",
                           "map.graphml", "map.dot", "routes.geojson"}) {
    std::error_code error;
    std::filesystem::remove(folder / name, error);
  }
}

}  // namespace asterism
