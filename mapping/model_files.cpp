#include "mapping/model_files.hpp"

#include <cmath>
#include <cstdint>

#include "io/atomic_file.hpp"
#include "io/grid/occupancy_map.hpp"
#include "io/grid/png_image.hpp"
#include "io/json/route_graph.hpp"
#include "io/log/pose_graph_file.hpp"
#include "io/log/trajectory_file.hpp"
#include "io/picture/map_graph.hpp"

namespace asterism {
namespace {

// White is free, black is a wall, the unknown in between: shades where it is not certain.
std::uint8_t grey_of(float log_odds) {
  const double occupied = 1 / (1 + std::exp(-static_cast<double>(log_odds)));
  return static_cast<std::uint8_t>(log_odds == 0 ? 205 : std::lround(254 * (1 - occupied)));
}

}  // namespace

void write_model(const std::filesystem::path& folder, const DrawnModel& model) {
  make_folder(folder);
  const auto file = [&](const char* name) { return (folder / name).string(); };
  const RankedMap& ranked = model.ranked;
  if (model.global_map) {
    write_trajectory_file(file("trajectory.tum"), model.trajectory);
    write_occupancy_map_file(file("map.yaml"), *model.global_map);
    write_png_file(file("map.png"), picture_of(*model.global_map, grey_of));
  }
  write_pose_graph_file(file("layout.g2o"),
                        {ranked.layout.layout_from_place, ranked.displacements, {PlaceId(0)}});
  write_atomically(file("map.graphml"), map_graphml(ranked.map, ranked.layout.layout_from_place));
  write_atomically(file("map.dot"), map_dot(ranked.map, ranked.layout.layout_from_place));
  if (!ranked.map.segments.empty())
    write_atomically(file("routes.geojson"),
                     route_graph_geojson(ranked.map, ranked.layout.layout_from_place));
}

}  // namespace asterism
