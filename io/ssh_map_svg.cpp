#include "io/ssh_map_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "io/path_colours.hpp"
#include "io/svg.hpp"

namespace asterism {
namespace {

using Point = MapDrawing::Point;

constexpr double pixels_per_unit = 110;
constexpr double margin = 36;
constexpr double disc = 15;
constexpr double line_height = 20;
constexpr double character_width = 7.6;  ///< an upper estimate at 13 px, whatever the font
constexpr double legend_width = 300;
constexpr double between_segments = 34;  ///< of the same places, at their middle

class Picture {
 public:
  Picture(const SshMap& map, const std::vector<Point>& places) : map_(map), places_(places) {
    if (places.size() != map.number_of_places() || places.empty())
      throw std::invalid_argument("not a point for each place");
    low_ = high_ = places.front();
    for (const auto& [x, y] : places) {
      low_ = {std::min(low_.x, x), std::min(low_.y, y)};
      high_ = {std::max(high_.x, x), std::max(high_.y, y)};
    }
  }

  std::string svg(const std::string& title) {
    legend_x_ = 3 * margin + pixels_per_unit * (high_.x - low_.x);
    const double width = legend_x_ + legend_width + margin;
    const auto columns = static_cast<std::size_t>((width - 2 * margin) / (1.25 * character_width));
    double y = margin;
    for (const std::string& line : wrapped(title, columns)) {
      y += line_height;
      add_text(margin, y, line, "font-size=\"16\" font-weight=\"bold\"");
    }
    top_ = legend_y_ = y + margin;
    draw_segments();
    for (std::size_t place = 0; place < places_.size(); ++place) draw_place(place);
    draw_legend();
    const double map_end = top_ + pixels_per_unit * (high_.y - low_.y);
    return svg_document(width, std::max(map_end, legend_y_) + margin, title, body_);
  }

 private:
  Point pixel(std::size_t place) const {
    return {margin + pixels_per_unit * (places_[place].x - low_.x),
            top_ + pixels_per_unit * (high_.y - places_[place].y)};
  }

  void add_text(double x, double y, const std::string& text, const std::string& style = "") {
    body_ +=
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, style, xml_text(text));
  }

  void draw_segments() {
    // Of segments between the same places, each bends aside by its own distance.
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> between;
    for (const auto& [from, to] : map_.segments)
      between[std::minmax(map_.places[from.index()].index(), map_.places[to.index()].index())]
          .push_back(map_.paths[from.index()].path.index());
    for (const auto& [ends, paths] : between)
      for (std::size_t i = 0; i < paths.size(); ++i)
        draw_segment(pixel(ends.first), pixel(ends.second),
                     between_segments *
                         (static_cast<double>(i) - (static_cast<double>(paths.size()) - 1) / 2),
                     paths[i]);
  }

  void draw_segment(Point from, Point to, double aside, std::size_t path) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (length < 1) {  // a loop above the place, each larger than the one before
      const double reach = 3 * disc + std::abs(aside);
      add_curve(fmt::format("M{0:.1f} {1:.1f}C{2:.1f} {3:.1f} {4:.1f} {3:.1f} {0:.1f} {1:.1f}",
                            from.x, from.y, from.x - reach, from.y - reach, from.x + reach),
                path);
      return;
    }
    // A curve passes half as far aside as the point that bends it.
    const Point bend{(from.x + to.x) / 2 - 2 * aside * (to.y - from.y) / length,
                     (from.y + to.y) / 2 + 2 * aside * (to.x - from.x) / length};
    add_curve(fmt::format("M{:.1f} {:.1f}Q{:.1f} {:.1f} {:.1f} {:.1f}", from.x, from.y, bend.x,
                          bend.y, to.x, to.y),
              path);
  }

  void add_curve(const std::string& curve, std::size_t path) {
    body_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"5\"/>\n", curve,
                         path_colour(path));
  }

  void draw_place(std::size_t place) {
    const auto [x, y] = pixel(place);
    const bool has_robot = map_.places[map_.dstates.back().index()].index() == place;
    body_ += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"#ffffff\" stroke=\"#222222\" "
        "stroke-width=\"{}\"/>\n",
        x, y, disc, has_robot ? 5 : 2);
    add_text(x, y + 4.5, std::to_string(place), "text-anchor=\"middle\"");
  }

  void draw_legend() {
    add_legend("Paths, with their places", 0, "font-weight=\"bold\"");
    for (std::size_t path = 0; path < map_.number_of_paths(); ++path) {
      std::set<std::size_t> on;
      for (std::size_t d = 0; d < map_.paths.size(); ++d)
        if (map_.paths[d].path.index() == path) on.insert(map_.places[d].index());
      const double y = legend_y_ + line_height - 4.5;
      body_ += fmt::format(
          "<path d=\"M{:.1f} {:.1f}H{:.1f}\" fill=\"none\" stroke=\"{}\" stroke-width=\"5\"/>\n",
          legend_x_, y, legend_x_ + 22, path_colour(path));
      add_legend(fmt::format("{}: {}", path, list(on)), 30);
    }
    legend_y_ += line_height / 2;
    add_legend("Places, with the views seen there", 0, "font-weight=\"bold\"");
    for (std::size_t place = 0; place < places_.size(); ++place) {
      std::set<std::size_t> views;
      for (std::size_t k = 0; k < map_.dstates.size(); ++k)
        if (map_.places[map_.dstates[k].index()].index() == place) views.insert(k);
      add_legend(
          fmt::format("place {}: view{} {}", place, views.size() == 1 ? "" : "s", list(views)), 0);
    }
    legend_y_ += line_height / 2;
    add_legend("The robot is at the place with the thick ring.", 0);
  }

  static std::string list(const std::set<std::size_t>& numbers) {
    std::string result;
    for (const std::size_t number : numbers)
      result += (result.empty() ? "" : ", ") + std::to_string(number);
    return result;
  }

  void add_legend(const std::string& text, double indent, const std::string& style = "") {
    const auto columns = static_cast<std::size_t>((legend_width - indent) / character_width);
    for (const std::string& line : wrapped(text, columns)) {
      legend_y_ += line_height;
      add_text(legend_x_ + indent, legend_y_, line, style);
    }
  }

  const SshMap& map_;
  const std::vector<Point>& places_;
  Point low_, high_;
  double top_ = 0;
  double legend_x_ = 0;
  double legend_y_ = 0;
  std::string body_;
};

}  // namespace

std::string ssh_map_svg(const SshMap& map, const std::vector<MapDrawing::Point>& places,
                        const std::string& title) {
  return Picture(map, places).svg(title);
}

}  // namespace asterism
