#include "io/picture/map_graph.hpp"

#include <limits>

#include "io/json/json_node.hpp"
#include "io/json/route_graph.hpp"
#include "io/json/trace_file.hpp"
#include "io/picture/map_osm.hpp"
#include "tests/io/corpus.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

//  0 ---- 1     the corner: out of 0 by a+, into 1 by c-, out by d+, into 2 by a+
//         |
//         2
TopologicalMap corner() {
  const Trace trace = read_trace_file(std::string(ASTERISM_SOURCE_DIR) +
                                      "/tests/corpus/trace/good/corner.trace.json");
  return make_map(
      trace, std::vector<Arrival>{{PlaceId(0), std::nullopt}, {PlaceId(1), 2U}, {PlaceId(2), 0U}});
}

const std::vector<Pose2> layout{{0, 0, 0}, {12.5, 0, 0.25}, {12, -8, -1.5}};

const DrivenWays ways{
    layout, {{{{0, 0}, {6, 0.5}, {12.5, 0}}, 12.75, 2.5}, {{{12.5, 0}, {12, -8}}, 8.25, 1.875}}};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t number = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++number;
  return number;
}

}  // namespace

TEST_CASE("a map as GraphML has a node a place, an edge a segment", "[io]") {
  CHECK(map_graphml(corner(), layout) ==
        content(std::string(ASTERISM_SOURCE_DIR) + "/tests/corpus/graphs/corner.graphml"));
  const std::string plain = map_graphml(corner());
  CHECK(count(plain, "<node ") == 3);
  CHECK(count(plain, "<edge ") == 2);
  CHECK(count(plain, "x_m") == 0);
  CHECK(count(plain, "LINESTRING") == 0);
  const std::string driven = map_graphml(corner(), layout, ways.of_segment);
  CHECK(count(driven, "<data key=\"line\">LINESTRING (0 0, 6 0.5, 12.5 0)</data>") == 1);
  CHECK(count(driven, "<data key=\"length_m\">8.25</data>") == 1);
  CHECK(count(driven, "<data key=\"width_m\">1.875</data>") == 1);
}

TEST_CASE("a map as DOT has its places pinned where they are laid out", "[io]") {
  CHECK(map_dot(corner(), layout) ==
        content(std::string(ASTERISM_SOURCE_DIR) + "/tests/corpus/graphs/corner.dot"));
  CHECK(count(map_dot(corner()), "pos=") == 0);
}

TEST_CASE("a map of one place is a graph of one node", "[io]") {
  const Trace trace{"", {{.star = Star::parse("a+1 a-1")}}};
  const auto map = make_map(trace, std::vector<Arrival>{{PlaceId(0), std::nullopt}});
  CHECK(count(map_graphml(map), "<node ") == 1);
  CHECK(count(map_dot(map), "--") == 0);
  CHECK(count(route_graph_geojson(map, {std::vector<Pose2>(1)}), "Feature\"") == 1);
  CHECK(count(map_osm(map, {std::vector<Pose2>(1)}), "<node ") == 1);
}

TEST_CASE("a graph of routes goes both ways, with ids of its own", "[io]") {
  const std::string text = route_graph_geojson(corner(), ways, "the \"map\"");
  const JsonDocument document{"routes", parse_json(text, "routes")};
  const JsonNode root(document);
  root["type"].require("\"FeatureCollection\"");
  const auto features = root["features"].items();
  REQUIRE(features.size() == 3 + 2 * 2);
  std::vector<std::vector<std::uint64_t>> edges;
  for (std::size_t i = 0; i < features.size(); ++i) {
    features[i]["type"].require("\"Feature\"");
    const JsonNode properties = features[i]["properties"];
    CHECK(properties["id"].count() == i);
    const JsonNode geometry = features[i]["geometry"];
    if (i < 3) {
      CHECK(geometry["type"].string() == "Point");
      CHECK(properties["frame"].string() == "the \"map\"");
      CHECK(geometry["coordinates"].items(2, "numbers")[0].number() == layout[i].x_m);
      CHECK(geometry["coordinates"].items(2, "numbers")[1].number() == layout[i].y_m);
      continue;
    }
    CHECK(geometry["type"].string() == "MultiLineString");
    const std::uint64_t start = properties["startid"].count(), end = properties["endid"].count();
    edges.push_back({start, end});
    const DrivenWay& way = ways.of_segment[(i - 3) / 2];
    const auto line = geometry["coordinates"].items(1, "line")[0].items(way.line.size(), "points");
    CHECK(line.front().items(2, "numbers")[0].number() == layout[start].x_m);
    CHECK(line.back().items(2, "numbers")[1].number() == layout[end].y_m);
    CHECK(properties["metadata"]["length_m"].number() == way.length_m);
    CHECK(properties["metadata"]["width_m"].number() == way.width_m);
  }
  CHECK(edges == std::vector<std::vector<std::uint64_t>>{{0, 1}, {1, 0}, {1, 2}, {2, 1}});
  const JsonNode back = features[4]["properties"]["metadata"];
  CHECK(back["start_arm"].string() == "c-");
  CHECK(back["end_arm"].string() == "a+");
}

TEST_CASE("a map as OpenStreetMap has it: a node a point, each once, a way a segment", "[io]") {
  CHECK(map_osm(corner(), ways) ==
        content(std::string(ASTERISM_SOURCE_DIR) + "/tests/corpus/graphs/corner.osm"));
}

TEST_CASE("ways that are not the map's are refused", "[io]") {
  DrivenWays wrong = ways;
  SECTION("one too few") { wrong.of_segment.pop_back(); }
  SECTION("no number") {
    wrong.of_segment[0].line[1].y_m = std::numeric_limits<double>::infinity();
  }
  CHECK_THROWS_AS(map_graphml(corner(), layout, wrong.of_segment), std::invalid_argument);
  CHECK_THROWS_AS(map_osm(corner(), wrong), std::invalid_argument);
  CHECK_THROWS_AS(route_graph_geojson(corner(), wrong), std::invalid_argument);
}

TEST_CASE("a layout that is not the map's is refused", "[io]") {
  std::vector<Pose2> wrong = layout;
  SECTION("a place too many") { wrong.push_back({}); }
  SECTION("a place too few") { wrong.pop_back(); }
  SECTION("no number") { wrong[1].x_m = std::numeric_limits<double>::quiet_NaN(); }
  CHECK_THROWS_AS(map_graphml(corner(), wrong), std::invalid_argument);
  CHECK_THROWS_AS(map_dot(corner(), wrong), std::invalid_argument);
  CHECK_THROWS_AS(map_osm(corner(), {wrong, ways.of_segment}), std::invalid_argument);
  CHECK_THROWS_AS(route_graph_geojson(corner(), {wrong, ways.of_segment}), std::invalid_argument);
  CHECK_THROWS_AS(route_graph_geojson(corner(), ways, "\xff"), std::invalid_argument);
}

}  // namespace asterism
