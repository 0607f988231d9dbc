#include "io/map_svg.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/map_figure.hpp"
#include "io/svg.hpp"
#include "io/svg_pen.hpp"

namespace asterism {
namespace {

constexpr double margin = 28;
constexpr double line_height = 20;
constexpr double character_width = 7.6;  ///< an upper estimate at 13 px, whatever the font
constexpr double legend_width = 300;

class Picture {
 public:
  Picture(const TopologicalMap& map, const MapDrawing& drawing)
      : map_(map), figure_(map, drawing) {}

  std::string bare_svg(const std::string& title) {
    draw_map(margin);
    return svg_document(2 * margin + figure_.width(), 2 * margin + figure_.height(), title,
                        pen_.body());
  }

  std::string svg(const std::string& title) {
    legend_x_ = margin + figure_.width() + 2 * margin;
    const double width = legend_x_ + legend_width + margin;
    const auto columns = static_cast<std::size_t>((width - 2 * margin) / (1.25 * character_width));
    double y = margin;
    for (const std::string& line : wrapped(title, columns)) {
      y += line_height;
      pen_.text({margin, y}, line, "font-size=\"16\" font-weight=\"bold\"");
    }
    const double top = y + margin;
    draw_map(top);
    const double legend_end = draw_legend(top);
    const double height = std::max(top + figure_.height(), legend_end) + margin;
    return svg_document(width, height, title, pen_.body());
  }

 private:
  void draw_map(double top) {
    figure_.draw(pen_, {margin, top}, {});
    figure_.draw_robot(pen_);
  }

  /// The paths with their places in order, what the signs mean, the visits of each place. Returns
  /// the y of its end.
  double draw_legend(double top) {
    legend_y_ = top;
    add_legend_line("Paths, with their places in order", "font-weight=\"bold\"");
    for (std::size_t i = 0; i < map_.paths.size(); ++i) {
      std::string places;
      for (const PlaceId place : map_.paths[i].places)
        places += (places.empty() ? "" : " \u2013 ") + std::to_string(place.index());
      if (map_.paths[i].ends.empty()) places += " \u2013 closed";
      const double y = legend_y_ + line_height - 4.5;
      pen_.line({legend_x_, y}, {legend_x_ + 22, y}, MapFigure::stroke(i));
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
    pen_.line({legend_x_, y}, {legend_x_ + 15, y}, grey + " stroke-dasharray=\"5 3\"");
    pen_.line({legend_x_ + 15, y - 2}, {legend_x_ + 21, y - 7}, grey);
    pen_.line({legend_x_ + 15, y + 2}, {legend_x_ + 21, y + 7}, grey);
    add_legend_text(30, "open gateway");
    pen_.line({legend_x_, y + line_height}, {legend_x_ + 18, y + line_height}, grey);
    pen_.line({legend_x_ + 18, y + line_height - 7}, {legend_x_ + 18, y + line_height + 7}, grey);
    add_legend_text(30, "the path ends here");
    MapFigure::draw_robot_arrow(pen_, {legend_x_ - 11, y + 2 * line_height}, {1, 0});
    add_legend_text(30, "the robot");
  }

  void add_legend_line(const std::string& text, const std::string& style = "", double indent = 0) {
    legend_y_ += line_height;
    pen_.text({legend_x_ + indent, legend_y_}, text, style);
  }

  void add_legend_text(double indent, const std::string& text) {
    const auto columns = static_cast<std::size_t>((legend_width - indent) / character_width);
    for (const std::string& line : wrapped(text, columns)) add_legend_line(line, "", indent);
  }

  const TopologicalMap& map_;
  MapFigure figure_;
  double legend_x_ = 0;
  double legend_y_ = 0;
  SvgPen pen_;
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
