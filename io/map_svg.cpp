#include "io/map_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "io/path_colours.hpp"
#include "io/path_of_arm.hpp"
#include "io/svg.hpp"

namespace asterism {
namespace {

using Point = MapDrawing::Point;

constexpr double pixels_per_unit = 160;
constexpr double margin = 28;
constexpr double disc = 15;
constexpr double bend_radius = 16;
constexpr double line_height = 20;
constexpr double character_width = 7.6;  ///< an upper estimate at 13 px, whatever the font
constexpr double legend_width = 300;

Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
Point operator*(double factor, Point a) { return {factor * a.x, factor * a.y}; }
double length(Point a) { return std::hypot(a.x, a.y); }

/// The point `pixels` away from one point in the direction of another.
Point towards(Point from, Point to, double pixels) {
  return from + (pixels / length(to - from)) * (to - from);
}

class Picture {
 public:
  Picture(const TopologicalMap& map, const MapDrawing& drawing)
      : map_(map), drawing_(drawing), paths_(paths_of_arms(map)) {
    low_ = high_ = drawing.places.at(0);
    const auto include = [&](Point point) {
      low_ = {std::min(low_.x, point.x), std::min(low_.y, point.y)};
      high_ = {std::max(high_.x, point.x), std::max(high_.y, point.y)};
    };
    for (const Point& place : drawing.places) include(place);
    for (const auto& arms : drawing.arms) std::for_each(arms.begin(), arms.end(), include);
    for (const auto& line : drawing.segments) std::for_each(line.begin(), line.end(), include);
  }

  std::string bare_svg(const std::string& title) {
    top_ = margin;
    draw_map();
    return svg_document(2 * margin + pixels_per_unit * (high_.x - low_.x),
                        2 * margin + pixels_per_unit * (high_.y - low_.y), title, body_);
  }

  std::string svg(const std::string& title) {
    const double map_width = pixels_per_unit * (high_.x - low_.x);
    const double map_height = pixels_per_unit * (high_.y - low_.y);
    legend_x_ = margin + map_width + 2 * margin;
    const double width = legend_x_ + legend_width + margin;
    const auto columns = static_cast<std::size_t>((width - 2 * margin) / (1.25 * character_width));
    double y = margin;
    for (const std::string& line : wrapped(title, columns)) {
      y += line_height;
      add_text(margin, y, line, "font-size=\"16\" font-weight=\"bold\"");
    }
    top_ = y + margin;
    draw_map();
    const double legend_end = draw_legend();
    const double height = std::max(top_ + map_height, legend_end) + margin;
    return svg_document(width, height, title, body_);
  }

 private:
  Point pixel(Point point) const {
    return {margin + pixels_per_unit * (point.x - low_.x),
            top_ + pixels_per_unit * (high_.y - point.y)};
  }

  void add_text(double x, double y, const std::string& text, const std::string& style = "") {
    body_ +=
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, style, xml_text(text));
  }

  void add_line(Point from, Point to, const std::string& style) {
    body_ += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" {}/>\n", from.x, from.y, to.x,
                         to.y, style);
  }

  static std::string stroke(std::size_t path, const char* more = "") {
    return fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"5\" {}", path_colour(path),
                       more);
  }

  void draw_map() {
    for (std::size_t s = 0; s < map_.segments.size(); ++s) draw_segment(s);
    PathOfArm open = paths_;
    for (const auto& [one, other] : map_.segments) {
      open.erase(one);
      open.erase(other);
    }
    for (const auto& [arm, path] : open) draw_arm(arm, path);
    for (std::size_t p = 0; p < map_.places.size(); ++p) draw_place(p);
    draw_robot();
  }

  void draw_segment(std::size_t segment) {
    MapDrawing::Polyline line;
    for (const Point& point : drawing_.segments[segment]) line.push_back(pixel(point));
    std::string d = fmt::format("M{:.1f} {:.1f}", line.front().x, line.front().y);
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      const double radius = std::min(
          {bend_radius, length(line[i] - line[i - 1]) / 2, length(line[i + 1] - line[i]) / 2});
      const Point before = towards(line[i], line[i - 1], radius);
      const Point after = towards(line[i], line[i + 1], radius);
      d += fmt::format("L{:.1f} {:.1f}Q{:.1f} {:.1f} {:.1f} {:.1f}", before.x, before.y, line[i].x,
                       line[i].y, after.x, after.y);
    }
    d += fmt::format("L{:.1f} {:.1f}", line.back().x, line.back().y);
    if (!drawing_.without_crossings)  // a gap where it passes over another
      body_ +=
          fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#ffffff\" stroke-width=\"13\"/>\n", d);
    const std::size_t path = paths_.at(map_.segments[segment].first);
    body_ += fmt::format("<path d=\"{}\" {}/>\n", d, stroke(path));
  }

  void draw_arm(PlaceArm arm, std::size_t path) {
    const auto [place, tip] = pixels(arm);
    const Point along = towards({0, 0}, tip - place, 1);
    const Point aside{-along.y, along.x};
    if (map_.places[arm.place.index()].star.has_gateway(arm.arm)) {
      add_line(place + disc * along, place + 31 * along, stroke(path, "stroke-dasharray=\"5 3\""));
      for (const double side : {-1.0, 1.0})  // the mouth of a corridor
        add_line(place + 31 * along + (2.5 * side) * aside, place + 38 * along + (8 * side) * aside,
                 fmt::format("stroke=\"{}\" stroke-width=\"2.5\"", path_colour(path)));
    } else {
      const Point end = place + 30 * along;
      add_line(place + disc * along, end, stroke(path));
      add_line(end + 8.0 * aside, end - 8.0 * aside, stroke(path));
    }
  }

  std::pair<Point, Point> pixels(PlaceArm arm) const {
    const std::size_t p = arm.place.index();
    return {pixel(drawing_.places[p]), pixel(drawing_.arms[p][arm.arm])};
  }

  /// A disc with the local-paths running through it, and its number.
  void draw_place(std::size_t p) {
    const Point centre = pixel(drawing_.places[p]);
    body_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"#ffffff\"/>\n",
                         centre.x, centre.y, disc);
    for (std::size_t arm = 0; arm < map_.places[p].star.size(); ++arm) {
      const PlaceArm place_arm{PlaceId(p), arm};
      add_line(centre, towards(centre, pixels(place_arm).second, disc),
               stroke(paths_.at(place_arm)));
    }
    body_ += fmt::format(
        "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"{2}\" fill=\"none\" stroke=\"#222222\" "
        "stroke-width=\"2\"/>\n<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"{3}\" "
        "fill=\"#ffffff\"/>\n",
        centre.x, centre.y, disc, disc - 4.5);
    add_text(centre.x, centre.y + 4.5, std::to_string(p), "text-anchor=\"middle\"");
  }

  void draw_robot() {
    const std::size_t p = map_.visits.back().index();
    const Star& star = map_.places[p].star;
    std::optional<std::size_t> facing = map_.left.back();
    if (!facing && map_.entered.back()) facing = star.opposite(*map_.entered.back());
    const Point centre = pixel(drawing_.places[p]);
    body_ += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"none\" stroke=\"#222222\" "
        "stroke-width=\"4\"/>\n",
        centre.x, centre.y, disc + 1);
    if (!facing) return;
    draw_arrow(centre, towards({0, 0}, pixels({PlaceId(p), *facing}).second - centre, 1));
  }

  void draw_arrow(Point centre, Point along) {
    const Point aside{-along.y, along.x};
    const Point tip = centre + (disc + 13) * along;
    const Point left = centre + disc * along + 10.0 * aside;
    const Point right = centre + disc * along - 10.0 * aside;
    body_ += fmt::format(
        "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\" fill=\"#222222\" "
        "stroke=\"#ffffff\" stroke-width=\"1.5\"/>\n",
        tip.x, tip.y, left.x, left.y, right.x, right.y);
  }

  /// The paths with their places in order, what the signs mean, the visits of each place. Returns
  /// the y of its end.
  double draw_legend() {
    legend_y_ = top_;
    add_legend_line("Paths, with their places in order", "font-weight=\"bold\"");
    for (std::size_t i = 0; i < map_.paths.size(); ++i) {
      std::string places;
      for (const PlaceId place : map_.paths[i].places)
        places += (places.empty() ? "" : " \u2013 ") + std::to_string(place.index());
      if (map_.paths[i].ends.empty()) places += " \u2013 closed";
      const double y = legend_y_ + line_height - 4.5;
      add_line({legend_x_, y}, {legend_x_ + 22, y}, stroke(i));
      add_legend_text(30, fmt::format("{}: {}", i, places));
    }
    legend_y_ += line_height / 2;
    add_legend_line("Places, with their visits", "font-weight=\"bold\"");
    for (std::size_t p = 0; p < map_.places.size(); ++p) {
      std::string visits;
      for (std::size_t k = 0; k < map_.visits.size(); ++k)
        if (map_.visits[k].index() == p) visits += (visits.empty() ? "" : ", ") + std::to_string(k);
      const bool one = visits.find(',') == std::string::npos;
      add_legend_text(0, fmt::format("place {}: visit{} {}", p, one ? "" : "s", visits));
    }
    legend_y_ += line_height / 2;
    add_signs();
    return legend_y_;
  }

  void add_signs() {
    const double y = legend_y_ + line_height - 4.5;
    const std::string grey = "stroke=\"#777777\" stroke-width=\"4\" fill=\"none\"";
    add_line({legend_x_, y}, {legend_x_ + 15, y}, grey + " stroke-dasharray=\"5 3\"");
    add_line({legend_x_ + 15, y - 2}, {legend_x_ + 21, y - 7}, grey);
    add_line({legend_x_ + 15, y + 2}, {legend_x_ + 21, y + 7}, grey);
    add_legend_text(30, "open gateway");
    add_line({legend_x_, y + line_height}, {legend_x_ + 18, y + line_height}, grey);
    add_line({legend_x_ + 18, y + line_height - 7}, {legend_x_ + 18, y + line_height + 7}, grey);
    add_legend_text(30, "the path ends here");
    draw_arrow({legend_x_ - disc + 4, y + 2 * line_height}, {1, 0});
    add_legend_text(30, "the robot");
  }

  void add_legend_line(const std::string& text, const std::string& style = "", double indent = 0) {
    legend_y_ += line_height;
    add_text(legend_x_ + indent, legend_y_, text, style);
  }

  void add_legend_text(double indent, const std::string& text) {
    const auto columns = static_cast<std::size_t>((legend_width - indent) / character_width);
    for (const std::string& line : wrapped(text, columns)) add_legend_line(line, "", indent);
  }

  const TopologicalMap& map_;
  const MapDrawing& drawing_;
  PathOfArm paths_;
  Point low_, high_;
  double top_ = 0;
  double legend_x_ = 0;
  double legend_y_ = 0;
  std::string body_;
};

}  // namespace

std::string map_svg(const TopologicalMap& map, const MapDrawing& drawing,
                    const std::string& title) {
  return Picture(map, drawing).svg(title);
}

std::string bare_map_svg(const TopologicalMap& map, const MapDrawing& drawing,
                         const std::string& title) {
  return Picture(map, drawing).bare_svg(title);
}

}  // namespace asterism
