#include "io/picture/map_graph.hpp"

#include <set>
#include <vector>

#include "io/bounds.hpp"
#include "io/path_of_arm.hpp"
#include "io/shown.hpp"

namespace asterism {
namespace {

struct Attribute {
  const char* name;
  const char* type;  ///< as GraphML has it
  std::string value;
};
using Attributes = std::vector<Attribute>;

std::string well_known_text(const std::vector<Point2>& line) {
  std::string points;
  for (const Point2 point : line)
    points += (points.empty() ? "" : ", ") + decimal(point.x_m) + ' ' + decimal(point.y_m);
  return "LINESTRING (" + points + ')';
}

/// What both languages tell of places and segments. Nothing in it needs an escape: labels are
/// letters and digits.
class MapGraph {
 public:
  MapGraph(const TopologicalMap& map, std::span<const Pose2> layout_from_place,
           std::span<const DrivenWay> ways)
      : map_(map), poses_(layout_from_place), ways_(ways), path_of_arm_(paths_of_arms(map)) {
    if (!poses_.empty()) require_poses(map, poses_);
    if (!ways_.empty()) require_ways(map, ways_);
  }

  Attributes of_place(std::size_t place) const {
    const auto& [star, first_visit] = map_.places[place];
    Attributes result{{"star", "string", star.text()},
                      {"first_visit", "int", std::to_string(first_visit.index())},
                      {"paths", "string", paths_through(place)}};
    if (poses_.empty()) return result;
    const Pose2& pose = poses_[place];
    result.push_back({"x_m", "double", decimal(pose.x_m)});
    result.push_back({"y_m", "double", decimal(pose.y_m)});
    result.push_back({"heading_rad", "double", decimal(pose.heading_rad)});
    return result;
  }

  Attributes of_segment(std::size_t segment) const {
    const auto& [one, other] = map_.segments[segment];
    Attributes result{{"source_arm", "string", name(one)},
                      {"target_arm", "string", name(other)},
                      {"path", "int", std::to_string(path_of_arm_.at(one))}};
    if (ways_.empty()) return result;
    const auto& [line, length_m, width_m] = ways_[segment];
    result.push_back({"length_m", "double", decimal(length_m)});
    result.push_back({"width_m", "double", decimal(width_m)});
    result.push_back({"line", "string", well_known_text(line)});
    return result;
  }

  std::string name(PlaceArm arm) const { return map_.places[arm.place.index()].star.name(arm.arm); }

 private:
  std::string paths_through(std::size_t place) const {
    std::set<std::size_t> paths;
    for (std::size_t arm = 0; arm < map_.places[place].star.size(); ++arm)
      paths.insert(path_of_arm_.at({PlaceId(place), arm}));
    std::string text;
    for (const std::size_t path : paths) text += (text.empty() ? "" : " ") + std::to_string(path);
    return text;
  }

  const TopologicalMap& map_;
  std::span<const Pose2> poses_;
  std::span<const DrivenWay> ways_;
  PathOfArm path_of_arm_;
};

std::string node_name(PlaceId place) { return 'p' + std::to_string(place.index()); }

std::string graphml_data(const Attributes& attributes) {
  std::string text;
  for (const Attribute& attribute : attributes)
    text +=
        std::string("      <data key=\"") + attribute.name + "\">" + attribute.value + "</data>\n";
  return text;
}

std::string graphml_keys(const Attributes& attributes, const char* of) {
  std::string text;
  for (const auto& [name, type, value] : attributes)
    text += std::string("  <key id=\"") + name + "\" for=\"" + of + "\" attr.name=\"" + name +
            "\" attr.type=\"" + type + "\"/>\n";
  return text;
}

std::string dot_list(const Attributes& attributes) {
  std::string text;
  for (const auto& [name, type, value] : attributes)
    text += std::string(", ") + name + "=\"" + value + '"';
  return text;
}

}  // namespace

std::string map_graphml(const TopologicalMap& map, std::span<const Pose2> layout_from_place,
                        std::span<const DrivenWay> ways) {
  const MapGraph graph(map, layout_from_place, ways);
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n";
  if (!map.places.empty()) text += graphml_keys(graph.of_place(0), "node");
  if (!map.segments.empty()) text += graphml_keys(graph.of_segment(0), "edge");
  text += "  <graph id=\"map\" edgedefault=\"undirected\">\n";
  for (std::size_t i = 0; i < map.places.size(); ++i)
    text += "    <node id=\"" + node_name(PlaceId(i)) + "\">\n" + graphml_data(graph.of_place(i)) +
            "    </node>\n";
  for (std::size_t i = 0; i < map.segments.size(); ++i)
    text += "    <edge id=\"s" + std::to_string(i) + "\" source=\"" +
            node_name(map.segments[i].first.place) + "\" target=\"" +
            node_name(map.segments[i].second.place) + "\">\n" + graphml_data(graph.of_segment(i)) +
            "    </edge>\n";
  return text + "  </graph>\n</graphml>\n";
}

std::string map_dot(const TopologicalMap& map, std::span<const Pose2> layout_from_place,
                    std::span<const DrivenWay> ways) {
  const MapGraph graph(map, layout_from_place, ways);
  std::string text =
      "graph map {\n  graph [layout=neato, inputscale=5]\n  node [shape=circle]\n"
      "  edge [fontsize=10]\n";
  for (std::size_t i = 0; i < map.places.size(); ++i) {
    text += "  " + node_name(PlaceId(i)) + " [label=\"" + std::to_string(i) + '"';
    if (!layout_from_place.empty())
      text += ", pos=\"" + decimal(layout_from_place[i].x_m) + ',' +
              decimal(layout_from_place[i].y_m) + "!\"";
    text += dot_list(graph.of_place(i)) + "]\n";
  }
  for (std::size_t i = 0; i < map.segments.size(); ++i) {
    const auto& [one, other] = map.segments[i];
    text += "  " + node_name(one.place) + " -- " + node_name(other.place) + " [id=\"s" +
            std::to_string(i) + "\", taillabel=\"" + graph.name(one) + "\", headlabel=\"" +
            graph.name(other) + '"' + dot_list(graph.of_segment(i)) + "]\n";
  }
  return text + "}\n";
}

}  // namespace asterism
