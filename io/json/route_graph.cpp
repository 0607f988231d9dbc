#include "io/json/route_graph.hpp"

#include <array>
#include <stdexcept>
#include <utility>
#include <vector>

#include "io/bounds.hpp"
#include "io/json/json_writer.hpp"
#include "io/path_of_arm.hpp"

namespace asterism {
namespace {

std::pair<double, double> point(const Pose2& pose) { return {pose.x_m, pose.y_m}; }

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

std::string route_graph_geojson(const TopologicalMap& map, std::span<const Pose2> layout_from_place,
                                const std::string& frame) {
  if (layout_from_place.size() != map.places.size())
    throw std::invalid_argument("layout: found " + std::to_string(layout_from_place.size()) +
                                " poses; expected " + std::to_string(map.places.size()));
  for (const Pose2& pose : layout_from_place) require_writable(pose, "layout");

  JsonWriter json;
  const auto write_place = [&](std::size_t place) {
    const Pose2& pose = layout_from_place[place];
    const auto properties = [&] {
      json.member("id", place, "frame", frame);
      json.key("metadata").object("star", map.places[place].star, "heading_rad", pose.heading_rad);
    };
    write_feature(json, "Point", properties, point(pose));
  };
  const PathOfArm paths = paths_of_arms(map);
  const auto name = [&](PlaceArm arm) { return map.places[arm.place.index()].star.name(arm.arm); };
  const auto write_edge = [&](std::size_t id, PlaceArm from, PlaceArm to) {
    const auto properties = [&] {
      json.member("id", id, "startid", from.place, "endid", to.place);
      json.key("metadata")
          .object("path", paths.at(from), "start_arm", name(from), "end_arm", name(to));
    };
    const std::array line{point(layout_from_place[from.place.index()]),
                          point(layout_from_place[to.place.index()])};
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
      for (const auto& [one, other] : map.segments) {
        write_edge(id++, one, other);
        write_edge(id++, other, one);
      }
    });
  });
  return json.take() + '\n';
}

}  // namespace asterism
