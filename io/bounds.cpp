#include "io/bounds.hpp"

#include <cstddef>
#include <stdexcept>

namespace asterism {
namespace {

void require_count(std::size_t found, std::size_t expected, const std::string& what,
                   const char* of) {
  if (found == expected) return;
  throw std::invalid_argument(what + ": found " + std::to_string(found) + ' ' + of + "; expected " +
                              std::to_string(expected));
}

}  // namespace

void require_writable(const Pose2& pose, const std::string& what) {
  if (!position_bounds_m.contain(pose.x_m) || !position_bounds_m.contain(pose.y_m) ||
      !heading_bounds_rad.contain(pose.heading_rad))
    throw std::invalid_argument(what +
                                ": found a pose out of all bounds; expected metres and radians");
}

void require_poses(const TopologicalMap& map, std::span<const Pose2> layout_from_place) {
  require_count(layout_from_place.size(), map.places.size(), "layout", "poses");
  for (const Pose2& pose : layout_from_place) require_writable(pose, "layout");
}

void require_ways(const TopologicalMap& map, std::span<const DrivenWay> ways) {
  require_count(ways.size(), map.segments.size(), "ways", "lines");
  for (const DrivenWay& way : ways)
    for (const Point2 point : way.line) require_writable({point.x_m, point.y_m, 0}, "ways");
}

}  // namespace asterism
