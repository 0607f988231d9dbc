#include "io/log/pose_graph_file.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <istream>
#include <map>
#include <optional>
#include <ostream>
#include <set>
#include <stdexcept>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/line_words.hpp"
#include "io/shown.hpp"
#include "io/text_file.hpp"

namespace asterism {
namespace {

using Matrix3 = std::array<double, 9>;  // row by row, symmetric

// Of variances and of what is told of them, in m² or rad²: so that no inverse overflows.
constexpr Bounds diagonal_bounds{1e-20, 1e20};
// Of each direction, the share of its variance that the others do not tell; below, it is rounding.
constexpr double least_own_share = 1e-9;

/// The inverse of a matrix that is positive definite, clearly; nothing of any other. Worked out on
/// the correlations, so that metres and radians of any size count alike.
std::optional<Matrix3> inverse(const Matrix3& matrix) {
  std::array<double, 3> scale{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!diagonal_bounds.contain(matrix[4 * i])) return std::nullopt;
    scale[i] = std::sqrt(matrix[4 * i]);
  }
  const auto correlation = [&](std::size_t i, std::size_t j) {
    return matrix[3 * i + j] / (scale[i] * scale[j]);
  };
  const double a = correlation(0, 1), b = correlation(0, 2), c = correlation(1, 2);
  const double determinant = 1 - a * a - b * b - c * c + 2 * a * b * c;
  const std::array<double, 3> minors{1 - c * c, 1 - b * b, 1 - a * a};
  for (const double minor : minors)
    if (!(minor > 0 && determinant / minor >= least_own_share)) return std::nullopt;
  const Matrix3 adjugate{minors[0], b * c - a, a * c - b,  //
                         b * c - a, minors[1], a * b - c,  //
                         a * c - b, a * b - c, minors[2]};
  Matrix3 result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      result[3 * i + j] = adjugate[3 * i + j] / determinant / (scale[i] * scale[j]);
  return result;
}

/// A vertex named in a line, to be looked up when all are known.
struct Named {
  std::uint64_t id;
  std::string where;
};

class Reader {
 public:
  Reader(std::unique_ptr<std::istream> in, const std::string& name) : lines_(std::move(in), name) {}

  PoseGraph read() {
    while (auto line = next_data_line(lines_)) {
      const std::string_view tag = line->next_word();
      if (tag == "VERTEX_SE2")
        read_vertex(*line);
      else if (tag == "EDGE_SE2")
        read_edge(*line);
      else if (tag == "FIX")
        read_fixed(*line);
      else
        line->refuse(tag, "VERTEX_SE2, EDGE_SE2 or FIX");
    }
    if (poses_.empty()) throw InputError(lines_.name(), "no vertex", "at least one");
    return graph();
  }

 private:
  struct Edge {
    Named from, to;
    Displacement displacement;
  };

  void read_vertex(LineWords& line) {
    const std::uint64_t id = line.integer("id", UINT64_MAX);
    const Pose2 pose = line.pose("");
    line.end("theta");
    if (!poses_.emplace(id, pose).second)
      line.complain("vertex " + std::to_string(id) + " again", "each vertex once");
  }

  void read_edge(LineWords& line) {
    const std::uint64_t from = line.integer("id", UINT64_MAX);
    const std::uint64_t to = line.integer("id", UINT64_MAX);
    if (from == to)
      line.complain("an edge from vertex " + std::to_string(from) + " to itself",
                    "one between two vertices");
    const Pose2 pose = line.pose("d");
    Matrix3 information{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i; j < 3; ++j)
        information[3 * i + j] = information[3 * j + i] =
            line.number('I' + std::to_string(i + 1) + std::to_string(j + 1));
    line.end("I33");
    const auto covariance = inverse(information);
    if (!covariance)
      line.complain("an information matrix that is singular or indefinite",
                    "a positive definite one");
    edges_.push_back(
        {{from, lines_.where()}, {to, lines_.where()}, make_displacement(pose, *covariance)});
  }

  void read_fixed(LineWords& line) {
    do {
      const std::uint64_t id = line.integer("id", UINT64_MAX);
      if (!fixed_ids_.insert(id).second)
        line.complain("vertex " + std::to_string(id) + " fixed again", "each vertex once");
      fixed_.push_back({id, lines_.where()});
    } while (LineWords(line).next_word() != "");
  }

  PoseGraph graph() const {
    PoseGraph result;
    std::map<std::uint64_t, PlaceId> places;
    for (const auto& [id, pose] : poses_) {
      places.emplace(id, places.size());
      result.layout_from_place.push_back(pose);
    }
    const auto place_of = [&](const Named& vertex) {
      const auto place = places.find(vertex.id);
      if (place == places.end())
        throw InputError(vertex.where, "vertex " + std::to_string(vertex.id),
                         "one that has a line VERTEX_SE2");
      return place->second;
    };
    for (const Edge& edge : edges_)
      result.displacements.push_back({place_of(edge.from), place_of(edge.to), edge.displacement});
    for (const Named& vertex : fixed_) result.fixed.push_back(place_of(vertex));
    return result;
  }

  LineReader lines_;
  std::map<std::uint64_t, Pose2> poses_;
  std::vector<Edge> edges_;
  std::vector<Named> fixed_;
  std::set<std::uint64_t> fixed_ids_;
};

[[noreturn]] void refuse(const std::string& found, const std::string& expected) {
  throw std::invalid_argument("pose graph: found " + found + "; expected " + expected);
}

std::string pose_text(const Pose2& pose) {
  require_writable(pose, "pose graph");
  return ' ' + decimal(pose.x_m) + ' ' + decimal(pose.y_m) + ' ' + decimal(pose.heading_rad);
}

/// The upper triangle of the inverse.
std::string information_text(const Matrix3& covariance) {
  if (!is_covariance(covariance)) refuse("an asymmetric or indefinite covariance", "one");
  const auto information = inverse(covariance);
  if (!information) refuse("a covariance that is singular", "a positive definite one");
  std::string text;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j) text += ' ' + decimal((*information)[3 * i + j]);
  return text;
}

}  // namespace

PoseGraph read_pose_graph(std::unique_ptr<std::istream> in, const std::string& name) {
  return Reader(std::move(in), name).read();
}
PoseGraph read_pose_graph_file(const std::string& file) {
  return read_pose_graph(opened_file(file), file);
}

void write_pose_graph(std::ostream& out, const PoseGraph& graph) {
  const std::size_t places = graph.layout_from_place.size();
  if (places == 0) refuse("no place", "at least one");
  const auto id_of = [&](PlaceId place) {
    if (place.index() >= places)
      refuse("place " + std::to_string(place.index()), "one of " + std::to_string(places));
    return std::to_string(place.index());
  };
  for (std::size_t i = 0; i < places; ++i)
    out << "VERTEX_SE2 " << i << pose_text(graph.layout_from_place[i]) << '\n';
  std::set<PlaceId> fixed;
  for (const PlaceId place : graph.fixed) {
    if (!fixed.insert(place).second) refuse("place " + id_of(place) + " fixed again", "each once");
    out << "FIX " << id_of(place) << '\n';
  }
  for (const auto& [from, to, displacement] : graph.displacements) {
    if (from == to) refuse("a displacement from place " + id_of(from) + " to itself", "another");
    const auto& [x_m, y_m, heading_rad, covariance] = displacement;
    out << "EDGE_SE2 " << id_of(from) << ' ' << id_of(to) << pose_text({x_m, y_m, heading_rad})
        << information_text(covariance) << '\n';
  }
}

void write_pose_graph_file(const std::string& file, const PoseGraph& graph) {
  write_atomically(file, [&](std::ostream& out) { write_pose_graph(out, graph); });
}

}  // namespace asterism
