#include "io/picture/map_osm.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "io/bounds.hpp"
#include "io/path_of_arm.hpp"

namespace asterism {
namespace {

constexpr double earth_radius_m = 6378137;  ///< of EPSG:3857

/// The attributes of where a point lies.
std::string at(Point2 point) {
  const double degrees = 180 / std::numbers::pi;
  return fmt::format("lat=\"{:.12f}\" lon=\"{:.12f}\"",
                     degrees * std::atan(std::sinh(point.y_m / earth_radius_m)),
                     degrees * point.x_m / earth_radius_m);
}

/// Keys and values need no escapes: words, numbers, and stars, which are letters, digits and signs.
std::string tag(const char* key, const std::string& value) {
  return fmt::format("    <tag k=\"{}\" v=\"{}\"/>\n", key, value);
}

}  // namespace

std::string map_osm(const TopologicalMap& map, const DrivenWays& ways) {
  require_poses(map, ways.layout_from_place);
  require_ways(map, ways.of_segment);
  // New things have numbers below 0.
  long long number = 0;
  std::string nodes;
  const auto add_node = [&](Point2 point, const std::string& tags) {
    nodes += fmt::format("  <node id=\"{}\" visible=\"true\" {}", --number, at(point));
    nodes += tags.empty() ? "/>\n" : ">\n" + tags + "  </node>\n";
    return number;
  };
  std::vector<long long> node_of_place;
  for (std::size_t i = 0; i < map.places.size(); ++i)
    node_of_place.push_back(add_node(ways.layout_from_place[i].position(),
                                     tag("name", "place " + std::to_string(i)) +
                                         tag("asterism:place", std::to_string(i)) +
                                         tag("asterism:star", map.places[i].star.text())));
  const PathOfArm paths = paths_of_arms(map);
  std::string lines;
  for (std::size_t i = 0; i < map.segments.size(); ++i) {
    const auto& [one, other] = map.segments[i];
    const DrivenWay& way = ways.of_segment[i];
    std::string line;
    const auto add = [&](long long node) { line += fmt::format("    <nd ref=\"{}\"/>\n", node); };
    add(node_of_place[one.place.index()]);
    for (std::size_t k = 1; k + 1 < way.line.size(); ++k) add(add_node(way.line[k], ""));
    add(node_of_place[other.place.index()]);
    line += tag("highway", "corridor") + tag("indoor", "yes") +
            tag("width", fmt::format("{:.2f}", way.width_m)) +
            tag("asterism:path", std::to_string(paths.at(one))) +
            tag("asterism:length", fmt::format("{:.2f}", way.length_m));
    lines += fmt::format("  <way id=\"{}\" visible=\"true\">\n{}  </way>\n", --number, line);
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<osm version=\"0.6\" generator=\"asterism\" upload=\"never\">\n" +
         nodes + lines + "</osm>\n";
}

}  // namespace asterism
