#include "cli/text/building_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "io/picture/svg.hpp"

namespace asterism {
namespace {

constexpr double pixels_per_m = 16;
constexpr double margin = 24;
constexpr double legend = 30;

/// Where points of the building are in the picture.
class Paper {
 public:
  explicit Paper(const std::vector<Wall>& walls, const std::vector<Pose2>& told) {
    for (const Wall& wall : walls) {
      take(wall.from);
      take(wall.to);
    }
    for (const Pose2& pose : told) take(pose.position());
  }

  double width() const { return pixels_per_m * (high_.x_m - low_.x_m) + 2 * margin; }
  double height() const { return pixels_per_m * (high_.y_m - low_.y_m) + 2 * margin + legend; }
  double x(Point2 point) const { return margin + pixels_per_m * (point.x_m - low_.x_m); }
  double y(Point2 point) const { return margin + pixels_per_m * (high_.y_m - point.y_m); }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  void take(Point2 point) {
    low_ = {std::min(low_.x_m, point.x_m), std::min(low_.y_m, point.y_m)};
    high_ = {std::max(high_.x_m, point.x_m), std::max(high_.y_m, point.y_m)};
  }

  Point2 low_{infinity, infinity};
  Point2 high_{-infinity, -infinity};
};

std::string line(const Paper& paper, Point2 from, Point2 to, const char* style) {
  return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" {}/>\n", paper.x(from),
                     paper.y(from), paper.x(to), paper.y(to), style);
}

/// The way of many poses; those within a pixel of one another are one.
std::string way(const Paper& paper, const std::vector<Pose2>& poses, const char* style) {
  std::string points;
  Point2 last{std::numeric_limits<double>::infinity(), 0};
  for (const Pose2& pose : poses) {
    if (norm(pose.position() - last) * pixels_per_m < 1) continue;
    last = pose.position();
    points +=
        fmt::format("{}{:.1f},{:.1f}", points.empty() ? "" : " ", paper.x(last), paper.y(last));
  }
  return fmt::format("<polyline points=\"{}\" fill=\"none\" {}/>\n", points, style);
}

std::string place(const Paper& paper, const Building& building, PlaceId id) {
  const auto& [position, star] = building.world.places[id.index()];
  const double radius_m = building.place_radius_m[id.index()];
  std::string result = fmt::format(
      "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"none\" "
      "stroke=\"#1f77b4\"/>\n",
      paper.x(position), paper.y(position), pixels_per_m * radius_m);
  const std::vector<double> headings_rad = arm_headings_rad(building.world, id);
  for (std::size_t arm = 0; arm < star.size(); ++arm) {
    const Point2 way = unit_vector(headings_rad[arm]);
    const double length_m = radius_m + (star.has_gateway(arm) ? 1.2 : 0.4);
    result += line(paper, position, position + length_m * way,
                   star.has_gateway(arm)
                       ? "stroke=\"#1f77b4\" stroke-width=\"2.5\""
                       : "stroke=\"#1f77b4\" stroke-width=\"1.2\" stroke-dasharray=\"4 3\"");
  }
  return result + fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-weight=\"bold\">{}</text>\n",
                              paper.x(position) + 8, paper.y(position) - 8, id.index());
}

}  // namespace

std::string building_svg(const Building& building, const std::vector<Pose2>& driven,
                         const std::vector<Pose2>& told) {
  const Paper paper(building.walls, told);
  std::string body = way(paper, told, "stroke=\"#bbbbbb\" stroke-dasharray=\"6 3\"");
  for (const Wall& wall : building.walls)
    body += line(paper, wall.from, wall.to,
                 wall.is_glass ? "stroke=\"#17becf\" stroke-width=\"3\""
                               : "stroke=\"#222222\" stroke-width=\"1.2\"");
  for (std::size_t i = 0; i < building.world.places.size(); ++i)
    body += place(paper, building, PlaceId(i));
  body += way(paper, driven, "stroke=\"#d62728\"");
  body += fmt::format(
      "<text x=\"{}\" y=\"{:.1f}\">{}: walls black, glass light blue; places with "
      "their arms blue; driven red, told by the wheels grey</text>\n",
      margin, paper.height() - 16, xml_text(building.name));
  return svg_document(paper.width(), paper.height(), "building " + building.name, body);
}

}  // namespace asterism
