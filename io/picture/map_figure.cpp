#include "io/picture/map_figure.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/picture/map_legend.hpp"

namespace asterism {
namespace {

constexpr double pixels_per_unit = 160;
constexpr double disc = 15;
constexpr double line_width = 5;
constexpr double bend_radius = 16;

}  // namespace

MapFigure::MapFigure(const TopologicalMap& map, const MapDrawing& drawing)
    : map_(map), drawing_(drawing), paths_(paths_of_arms(map)) {
  low_ = high_ = drawing.places.at(0);
  const auto include = [&](MapDrawing::Point point) {
    low_ = {std::min(low_.x, point.x), std::min(low_.y, point.y)};
    high_ = {std::max(high_.x, point.x), std::max(high_.y, point.y)};
  };
  for (const MapDrawing::Point& place : drawing.places) include(place);
  for (const auto& arms : drawing.arms) std::for_each(arms.begin(), arms.end(), include);
  for (const auto& line : drawing.segments) std::for_each(line.begin(), line.end(), include);
}

double MapFigure::width() const { return pixels_per_unit * (high_.x - low_.x); }
double MapFigure::height() const { return pixels_per_unit * (high_.y - low_.y); }

SvgPoint MapFigure::pixel(MapDrawing::Point point) const {
  return {corner_.x + pixels_per_unit * (point.x - low_.x),
          corner_.y + pixels_per_unit * (high_.y - point.y)};
}

std::pair<SvgPoint, SvgPoint> MapFigure::pixels(PlaceArm arm) const {
  const std::size_t p = arm.place.index();
  return {pixel(drawing_.places[p]), pixel(drawing_.arms[p][arm.arm])};
}

std::string MapFigure::stroke(std::size_t path, const char* more) {
  return fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" {}", path_colour(path),
                     line_width, more);
}

std::string MapFigure::stripe(std::size_t path) {
  const std::string attributes = path_stripe(path, line_width);
  return attributes.empty() ? attributes : "fill=\"none\" " + attributes;
}

std::string MapFigure::crossing_stroke() {
  return "fill=\"none\" stroke=\"#c00000\" stroke-width=\"5\"";
}

std::string MapFigure::band_stroke() {
  return "fill=\"none\" stroke=\"#ffd9b3\" stroke-width=\"21\" stroke-linecap=\"round\"";
}

void MapFigure::draw(SvgPen& pen, SvgPoint corner, const Marks& marks) {
  corner_ = corner;
  for (std::size_t s = 0; s < map_.segments.size(); ++s)
    if (s != marks.crossing) draw_segment(pen, s, marks);
  if (marks.crossing) draw_segment(pen, *marks.crossing, marks);
  PathOfArm open = paths_;
  for (const auto& [one, other] : map_.segments) {
    open.erase(one);
    open.erase(other);
  }
  for (const auto& [arm, path] : open) draw_arm(pen, arm, path);
  for (std::size_t p = 0; p < map_.places.size(); ++p) draw_place(pen, p, marks);
}

void MapFigure::draw_segment(SvgPen& pen, std::size_t segment, const Marks& marks) const {
  std::vector<SvgPoint> line;
  for (const MapDrawing::Point& point : drawing_.segments[segment]) line.push_back(pixel(point));
  const std::string d = rounded(line, bend_radius);
  if (marks.banded.contains(segment))
    pen.path(d, band_stroke());
  else if (!drawing_.without_crossings)  // a gap where it passes over another
    pen.path(d, "fill=\"none\" stroke=\"#ffffff\" stroke-width=\"13\"");
  if (segment == marks.crossing) {
    pen.path(d, crossing_stroke());
    return;
  }
  const std::size_t path = paths_.at(map_.segments[segment].first);
  pen.path(d, stroke(path));
  if (const std::string over = stripe(path); !over.empty()) pen.path(d, over);
}

void MapFigure::draw_path_line(SvgPen& pen, SvgPoint from, SvgPoint to, std::size_t path) {
  pen.line(from, to, stroke(path));
  if (const std::string over = stripe(path); !over.empty()) pen.line(from, to, over);
}

void MapFigure::draw_arm(SvgPen& pen, PlaceArm arm, std::size_t path) const {
  const auto [place, tip] = pixels(arm);
  const SvgPoint along = towards({0, 0}, tip - place, 1);
  const SvgPoint aside{-along.y, along.x};
  if (map_.places[arm.place.index()].star.has_gateway(arm.arm)) {
    pen.line(place + disc * along, place + 31 * along, stroke(path, "stroke-dasharray=\"5 3\""));
    for (const double side : {-1.0, 1.0})  // the mouth of a corridor
      pen.line(place + 31 * along + (2.5 * side) * aside, place + 38 * along + (8 * side) * aside,
               fmt::format("stroke=\"{}\" stroke-width=\"2.5\"", path_colour(path)));
  } else {
    const SvgPoint end = place + 30 * along;
    draw_path_line(pen, place + disc * along, end, path);
    pen.line(end + 8.0 * aside, end - 8.0 * aside, stroke(path));
  }
}

/// A disc with the local-paths running through it, and its number.
void MapFigure::draw_place(SvgPen& pen, std::size_t p, const Marks& marks) const {
  const SvgPoint centre = pixel(drawing_.places[p]);
  pen.circle(centre, disc, "fill=\"#ffffff\"");
  for (std::size_t arm = 0; arm < map_.places[p].star.size(); ++arm) {
    const PlaceArm place_arm{PlaceId(p), arm};
    draw_path_line(pen, centre, towards(centre, pixels(place_arm).second, disc),
                   paths_.at(place_arm));
  }
  pen.circle(centre, disc, "fill=\"none\" stroke=\"#222222\" stroke-width=\"2\"");
  pen.circle(centre, disc - 4.5, "fill=\"#ffffff\"");
  const std::size_t name = marks.names.empty() ? p : marks.names.at(p).index();
  pen.text({centre.x, centre.y + 4.5}, std::to_string(name), "text-anchor=\"middle\"");
}

void MapFigure::draw_robot(SvgPen& pen) const {
  const std::size_t p = map_.visits.back().index();
  const Star& star = map_.places[p].star;
  std::optional<std::size_t> facing = map_.left.back();
  if (!facing && map_.entered.back()) facing = star.opposite(*map_.entered.back());
  const SvgPoint centre = pixel(drawing_.places[p]);
  pen.circle(centre, disc + 1, "fill=\"none\" stroke=\"#222222\" stroke-width=\"4\"");
  if (!facing) return;
  draw_robot_arrow(pen, centre, towards({0, 0}, pixels({PlaceId(p), *facing}).second - centre, 1));
}

void MapFigure::draw_robot_arrow(SvgPen& pen, SvgPoint centre, SvgPoint along) {
  pen.arrow(centre + (disc + 13) * along, along, 13, 10,
            "fill=\"#222222\" stroke=\"#ffffff\" stroke-width=\"1.5\"");
}

}  // namespace asterism
