#include "io/log/pose_graph_file.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <sstream>

#include "core/error.hpp"
#include "core/random.hpp"
#include "tests/io/corpus.hpp"
#include "tests/io/folder.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double rounding = 1e-9;  // of covariances inverted twice, relative

PoseGraph graph_of(const std::string& text) {
  return read_pose_graph(std::make_unique<std::istringstream>(text), "graph");
}

std::string written(const PoseGraph& graph) {
  std::ostringstream out;
  write_pose_graph(out, graph);
  return out.str();
}

void check_same(const PoseGraph& a, const PoseGraph& b) {
  CHECK(a.layout_from_place == b.layout_from_place);
  CHECK(a.fixed == b.fixed);
  REQUIRE(a.displacements.size() == b.displacements.size());
  for (std::size_t i = 0; i < a.displacements.size(); ++i) {
    const auto& [from, to, one] = a.displacements[i];
    CHECK(from == b.displacements[i].from);
    CHECK(to == b.displacements[i].to);
    const Displacement& other = b.displacements[i].displacement;
    CHECK(one.x_m == other.x_m);
    CHECK(one.y_m == other.y_m);
    CHECK(one.heading_rad == other.heading_rad);
    for (std::size_t k = 0; k < 9; ++k) {
      const double scale = std::sqrt(one.covariance[4 * (k / 3)] * one.covariance[4 * (k % 3)]);
      CHECK(std::abs(one.covariance[k] - other.covariance[k]) <= rounding * scale);
    }
  }
}

/// M Mᵀ and something on the diagonal, in units as different as metres and radians may be.
PoseCovariance any_covariance(RandomEngine& random) {
  std::array<double, 9> root{};
  for (double& number : root) number = normal(random);
  const std::array<double, 3> unit{0.1, 0.02, 1e-3};
  PoseCovariance covariance{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      double sum = i == j ? 0.1 : 0;
      for (std::size_t k = 0; k < 3; ++k) sum += root[3 * i + k] * root[3 * j + k];
      covariance[3 * i + j] = unit[i] * unit[j] * sum;
    }
  return covariance;
}

PoseGraph any_graph(RandomEngine& random) {
  PoseGraph graph;
  const std::size_t places = 2 + below(20, random);
  for (std::size_t i = 0; i < places; ++i)
    graph.layout_from_place.push_back(
        {between(-1e3, 1e3, random), 1e-9 * normal(random), wrapped(between(-pi, pi, random))});
  for (std::size_t i = 0; i < 2 * places; ++i) {
    const std::size_t from = below(places, random);
    const std::size_t to = (from + 1 + below(places - 1, random)) % places;
    graph.displacements.push_back({PlaceId(from),
                                   PlaceId(to),
                                   {normal(random), normal(random),
                                    wrapped(between(-pi, pi, random)), any_covariance(random)}});
  }
  if (chance(0.8, random)) graph.fixed.push_back(PlaceId(below(places, random)));
  return graph;
}

}  // namespace

TEST_CASE("every good pose graph is read and, written, read again", "[io]") {
  for (const auto& file : good_files("g2o")) {
    INFO(file);
    const PoseGraph graph = read_pose_graph_file(file);
    check_same(graph_of(written(graph)), graph);
  }
}

TEST_CASE("what a pose graph says is read, in the order of the ids", "[io]") {
  const PoseGraph graph = read_pose_graph_file(std::string(ASTERISM_SOURCE_DIR) +
                                               "/tests/corpus/g2o/good/shuffled.g2o");
  CHECK(graph.layout_from_place == std::vector<Pose2>{{0, 0, 0}, {1, 1, 1}, {-3, 0, -1}});
  CHECK(graph.fixed == std::vector{PlaceId(1), PlaceId(0)});
  REQUIRE(graph.displacements.size() == 2);
  const auto& [from, to, edge] = graph.displacements[0];
  CHECK(from == PlaceId(1));
  CHECK(to == PlaceId(0));
  CHECK(edge.x_m == -1);
  CHECK(edge.y_m == 2);
  CHECK(edge.heading_rad == wrapped(9));
  // The information times the covariance is 1.
  const std::array<double, 9> information{25, 1, -2, 1, 16, 3, -2, 3, 100};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k)
        sum += information[3 * i + k] * edge.covariance[3 * k + j];
      CHECK(sum == Approx(i == j ? 1 : 0).margin(1e-12));
    }
}

TEST_CASE("a pose graph is written a part a line", "[io]") {
  const PoseGraph graph{
      {{0, 0, 0}, {2, 0.5, pi / 2}},
      {{PlaceId(0), PlaceId(1), {2, 0.5, 1.5, {0.25, 0, 0, 0, 0.0625, 0, 0, 0, 4}}}},
      {PlaceId(0)}};
  CHECK(written(graph) ==
        "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 2 0.5 1.5707963267948966\nFIX 0\n"
        "EDGE_SE2 0 1 2 0.5 1.5 4 0 0 16 0 0.25\n");
}

TEST_CASE("a pose graph is read as it was written, the lines in any order", "[io][property]") {
  const auto seed = GENERATE(range(0U, 40U));
  CAPTURE(seed);
  RandomEngine random(seed);
  const PoseGraph graph = any_graph(random);
  const Folder folder;
  const std::string file = folder.file("layout.g2o");
  write_pose_graph_file(file, graph);
  CHECK(folder.entries() == 1);
  CHECK(content(file) == written(graph));
  check_same(read_pose_graph_file(file), graph);

  std::istringstream in(content(file));
  std::vector<std::string> vertices, lines;
  for (std::string line; std::getline(in, line);)
    (line.starts_with("VERTEX") ? vertices : lines).push_back(line + '\n');
  std::shuffle(vertices.begin(), vertices.end(), random);
  std::string text;
  for (const std::string& line : lines) text += line;
  for (const std::string& line : vertices) text += line;
  check_same(graph_of(text), graph);
}

TEST_CASE("a pose graph that could not be read back is not written", "[io]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  PoseGraph graph{{{}, {1, 0, 0}},
                  {{PlaceId(0), PlaceId(1), {1, 0, 0, {1, 0, 0, 0, 1, 0, 0, 0, 1}}}},
                  {PlaceId(0)}};
  CHECK_NOTHROW(written(graph));
  Displacement& displacement = graph.displacements[0].displacement;
  SECTION("no place") { graph = {}; }
  SECTION("pose no number") { graph.layout_from_place[1].heading_rad = nan; }
  SECTION("displacement infinite") { displacement.x_m = HUGE_VAL; }
  SECTION("covariance singular") { displacement.covariance[8] = 0; }
  SECTION("covariance all zero") { displacement.covariance = {}; }
  SECTION("covariance asymmetric") { displacement.covariance[1] = 0.1; }
  SECTION("covariance indefinite") { displacement.covariance[1] = displacement.covariance[3] = -2; }
  SECTION("covariance no number") { displacement.covariance[4] = nan; }
  SECTION("from no place") { graph.displacements[0].from = PlaceId(2); }
  SECTION("to no place") { graph.displacements[0].to = PlaceId(9); }
  SECTION("to itself") { graph.displacements[0].to = PlaceId(0); }
  SECTION("no place fixed") { graph.fixed.push_back(PlaceId(2)); }
  SECTION("fixed twice") { graph.fixed.push_back(PlaceId(0)); }
  const Folder folder;
  CHECK_THROWS_AS(write_pose_graph_file(folder.file("layout.g2o"), graph), std::invalid_argument);
  CHECK(folder.entries() == 0);
}

}  // namespace asterism
