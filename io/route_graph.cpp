#include "io/route_graph.hpp"

#include <stdexcept>

#include "io/json_value.hpp"
#include "io/line_words.hpp"
#include "io/path_of_arm.hpp"

namespace asterism {
namespace {

std::string coordinates(const Pose2& pose) {
  return '[' + json_number(pose.x_m) + ", " + json_number(pose.y_m) + ']';
}

std::string feature(const std::string& properties, const std::string& type,
                    const std::string& place) {
  return "    { \"type\": \"Feature\", \"properties\": { " + properties +
         " },\n      \"geometry\": { \"type\": \"" + type + "\", \"coordinates\": " + place +
         " } }";
}

}  // namespace

std::string route_graph_geojson(const TopologicalMap& map, std::span<const Pose2> layout_from_place,
                                const std::string& frame) {
  if (layout_from_place.size() != map.places.size())
    throw std::invalid_argument("layout: found " + std::to_string(layout_from_place.size()) +
                                " poses; expected " + std::to_string(map.places.size()));
  for (const Pose2& pose : layout_from_place) require_writable(pose, "layout");

  std::string text =
      "{ \"type\": \"FeatureCollection\", \"name\": \"graph\",\n"
      "  \"crs\": { \"type\": \"name\", \"properties\": { \"name\": "
      "\"urn:ogc:def:crs:EPSG::3857\" } },\n"
      "  \"features\": [";
  for (std::size_t i = 0; i < map.places.size(); ++i)
    text +=
        (i == 0 ? "\n" : ",\n") +
        feature("\"id\": " + std::to_string(i) + ", \"frame\": " + json_quoted(frame) +
                    ", \"metadata\": { \"star\": " + json_quoted(map.places[i].star.text()) +
                    ", \"heading_rad\": " + json_number(layout_from_place[i].heading_rad) + " }",
                "Point", coordinates(layout_from_place[i]));

  const PathOfArm paths = paths_of_arms(map);
  std::size_t id = map.places.size();
  const auto add_edge = [&](PlaceArm from, PlaceArm to) {
    const auto name = [&](PlaceArm arm) {
      return json_quoted(map.places[arm.place.index()].star.name(arm.arm));
    };
    text +=
        ",\n" + feature("\"id\": " + std::to_string(id++) +
                            ", \"startid\": " + std::to_string(from.place.index()) +
                            ", \"endid\": " + std::to_string(to.place.index()) +
                            ", \"metadata\": { \"path\": " + std::to_string(paths.at(from)) +
                            ", \"start_arm\": " + name(from) + ", \"end_arm\": " + name(to) + " }",
                        "MultiLineString",
                        "[[" + coordinates(layout_from_place[from.place.index()]) + ", " +
                            coordinates(layout_from_place[to.place.index()]) + "]]");
  };
  for (const auto& [one, other] : map.segments) {
    add_edge(one, other);
    add_edge(other, one);
  }
  return text + " ] }\n";
}

}  // namespace asterism
