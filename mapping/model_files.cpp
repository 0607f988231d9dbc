#include "mapping/model_files.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include "io/atomic_file.hpp"
#include "io/grid/occupancy_map.hpp"
#include "io/grid/png_image.hpp"
#include "io/json/route_graph.hpp"
#include "io/log/pose_graph_file.hpp"
#include "io/log/trajectory_file.hpp"
#include "io/picture/map_graph.hpp"
#include "io/picture/map_osm.hpp"

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
  const std::vector<Pose2>& poses = ranked.layout.layout_from_place;
  const std::vector<DrivenWay>& ways = model.ways.of_segment;
  write_atomically(file("map.graphml"), map_graphml(ranked.map, poses, ways));
  write_atomically(file("map.dot"), map_dot(ranked.map, poses, ways));
  if (ways.empty()) return;
  write_atomically(file("routes.geojson"), route_graph_geojson(ranked.map, model.ways));
  write_atomically(file("routes.osm"), map_osm(ranked.map, model.ways));
}

}  // namespace asterism
