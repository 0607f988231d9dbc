#include "io/json/route_graph.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "io/bounds.hpp"
#include "io/json/json_writer.hpp"
#include "io/path_of_arm.hpp"

namespace asterism {
namespace {

std::pair<double, double> numbers(Point2 point) { return {point.x_m, point.y_m}; }

/// @param properties  writes its members
template <class Properties, class Coordinates>
void write_feature(JsonWriter& json, const char* type, Properties properties,
                   const Coordinates& coordinates) {
  json.line().object([&] {
    json.member("type", "Feature");
    json.key("properties").object(properties);
    json.line().key("geometry").object("type", type, "coordinates", coordinates);
  });
}

}  // namespace

std::string route_graph_geojson(const TopologicalMap& map, const DrivenWays& ways,
                                const std::string& frame) {
  require_poses(map, ways.layout_from_place);
  require_ways(map, ways.of_segment);

  JsonWriter json;
  const auto write_place = [&](std::size_t place) {
    const Pose2& pose = ways.layout_from_place[place];
    const auto properties = [&] {
      json.member("id", place, "frame", frame);
      json.key("metadata").object("star", map.places[place].star, "heading_rad", pose.heading_rad);
    };
    write_feature(json, "Point", properties, numbers(pose.position()));
  };
  const PathOfArm paths = paths_of_arms(map);
  const auto name = [&](PlaceArm arm) { return map.places[arm.place.index()].star.name(arm.arm); };
  const auto write_edge = [&](std::size_t id, PlaceArm from, PlaceArm to, const DrivenWay& way) {
    const auto properties = [&] {
      json.member("id", id, "startid", from.place, "endid", to.place);
      json.key("metadata")
          .object("path", paths.at(from), "start_arm", name(from), "end_arm", name(to), "length_m",
                  way.length_m, "width_m", way.width_m);
    };
    std::vector<std::pair<double, double>> line;
    for (const Point2 point : way.line) line.push_back(numbers(point));
    write_feature(json, "MultiLineString", properties, std::vector(1, line));
  };
  json.object([&] {
    json.member("type", "FeatureCollection", "name", "graph");
    json.line().key("crs").object([&] {
      json.member("type", "name");
      json.key("properties").object("name", "urn:ogc:def:crs:EPSG::3857");
    });
    json.line().key("features").array([&] {
      for (std::size_t i = 0; i < map.places.size(); ++i) write_place(i);
      std::size_t id = map.places.size();
      for (std::size_t i = 0; i < map.segments.size(); ++i) {
        const auto& [one, other] = map.segments[i];
        DrivenWay way = ways.of_segment[i];
        write_edge(id++, one, other, way);
        std::ranges::reverse(way.line);
        write_edge(id++, other, one, way);
      }
    });
  });
  return json.take() + '\n';
}

}  // namespace asterism
