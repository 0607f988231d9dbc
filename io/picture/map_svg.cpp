#include "io/picture/map_svg.hpp"

#include <fmt/format.h>

#include "io/picture/map_figure.hpp"
#include "io/picture/map_page.hpp"
#include "io/picture/svg.hpp"

namespace asterism {
namespace {

constexpr double margin = 28;

void draw_map(MapFigure& figure, SvgPen& pen, double top) {
  figure.draw(pen, {margin, top}, {});
  figure.draw_robot(pen);
}

void add_paths(MapPage& page, const TopologicalMap& map) {
  page.add_heading("Paths, with their places in order");
  for (std::size_t i = 0; i < map.paths.size(); ++i) {
    std::string places;
    for (const PlaceId place : map.paths[i].places)
      places += (places.empty() ? "" : " \u2013 ") + std::to_string(place.index());
    if (map.paths[i].ends.empty()) places += " \u2013 closed";
    MapFigure::draw_path_line(page.pen(), page.sign(), page.sign() + SvgPoint{22, 0}, i);
    page.add(fmt::format("{}: {}", i, places), 30);
  }
}

void add_places(MapPage& page, const TopologicalMap& map) {
  page.add_heading("Places, with their visits");
  for (std::size_t p = 0; p < map.places.size(); ++p) {
    std::string visits;
    for (std::size_t k = 0; k < map.visits.size(); ++k)
      if (map.visits[k].index() == p) visits += (visits.empty() ? "" : ", ") + std::to_string(k);
    const bool one = visits.find(',') == std::string::npos;
    page.add(fmt::format("place {}: visit{} {}", p, one ? "" : "s", visits));
  }
}

void add_signs(MapPage& page) {
  const std::string grey = "stroke=\"#777777\" stroke-width=\"4\" fill=\"none\"";
  const auto line = [&](SvgPoint from, SvgPoint to, const char* more = "") {
    page.pen().line(page.sign() + from, page.sign() + to, grey + more);
  };
  line({0, 0}, {15, 0}, " stroke-dasharray=\"5 3\"");
  line({15, -2}, {21, -7});
  line({15, 2}, {21, 7});
  page.add("open gateway", 30);
  line({0, 0}, {18, 0});
  line({18, -7}, {18, 7});
  page.add("the path ends here", 30);
  MapFigure::draw_robot_arrow(page.pen(), page.sign() + SvgPoint{-11, 0}, {1, 0});
  page.add("the robot", 30);
}

}  // namespace

std::string map_svg(const TopologicalMap& map, const MapDrawing& drawing,
                    const std::string& title) {
  MapFigure figure(map, drawing);
  MapPage page(title, margin, figure.width());
  draw_map(figure, page.pen(), page.top());
  add_paths(page, map);
  page.add_gap();
  add_places(page, map);
  page.add_gap();
  add_signs(page);
  return page.svg(figure.height());
}

std::string bare_map_svg(const TopologicalMap& map, const MapDrawing& drawing,
                         const std::string& title) {
  MapFigure figure(map, drawing);
  SvgPen pen;
  draw_map(figure, pen, margin);
  return svg_document(2 * margin + figure.width(), 2 * margin + figure.height(), title, pen.body());
}

}  // namespace asterism
