#include "perception/local_topology.hpp"

namespace asterism {

LocalTopology local_topology(const Grid& grid, Point2 robot, const LocalTopologyOptions& options,
                             std::span<const Point2> driven) {
  LocalTopology result;
  result.space = free_space(grid, options.free_space);
  result.skeleton = skeleton(result.space, grid.cell_at(robot), options.skeleton, driven);
  result.neighbourhood = neighbourhood(result.space, result.skeleton, robot);
  if (result.neighbourhood && !result.neighbourhood->gateways.empty()) {
    result.star = local_star(result.neighbourhood->gateways, options.star);
  }
  return result;
}

}  // namespace asterism
