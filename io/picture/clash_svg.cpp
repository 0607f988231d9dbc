#include "io/picture/clash_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "io/picture/clash_row.hpp"
#include "io/picture/map_figure.hpp"
#include "io/picture/svg.hpp"
#include "io/picture/svg_pen.hpp"

namespace asterism {
namespace {

constexpr double margin = 28;
constexpr double line_height = 20;
constexpr double character_width = 7.6;  ///< an upper estimate at 13 px, whatever the font
constexpr double legend_width = 300;
constexpr double min_width = 800;  ///< for the words
constexpr double max_name_width = 220;

/// Segments that join places next to each other on one of the loops.
std::set<std::size_t> segments_on(const ClashPicture::Crossing& crossing) {
  std::set<std::pair<PlaceId, PlaceId>> joined;
  for (const auto& loop : crossing.loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      joined.insert(std::minmax(loop[i], loop[(i + 1) % loop.size()]));
  std::set<std::size_t> result;
  for (std::size_t s = 0; s + 1 < crossing.map.segments.size(); ++s) {
    const auto& [one, other] = crossing.map.segments[s];
    if (joined.contains(std::minmax(one.place, other.place))) result.insert(s);
  }
  return result;
}

class Picture {
 public:
  Picture(const Trace& trace, const ClashPicture& clash) : clash_(clash), row_(trace, clash) {
    if (clash.crossing) figure_.emplace(clash.crossing->map, clash.crossing->drawing);
    inner_width_ = std::max(min_width, row_.width());
    if (figure_) inner_width_ = std::max(inner_width_, figure_->width() + margin + legend_width);
  }

  std::string svg() {
    add_words(margin, inner_width_, clash_.title, "font-size=\"16\" font-weight=\"bold\"", 1.25);
    y_ += line_height;
    if (row_.width() > 0) {
      row_.draw(pen_, {margin, y_});
      y_ += row_.height();
    }
    if (figure_) add_crossing();
    add_lines(clash_.visits.empty() ? "These cannot all be" : "Such visits and these cannot all be",
              clash_.said);
    add_lines("None can be spared: what the others allow, without", clash_.without);
    return svg_document(std::max(inner_width_ + margin, right_) + margin, y_ + margin, clash_.title,
                        pen_.body());
  }

 private:
  /// Goes on below.
  void add_words(double x, double width, const std::string& words, const std::string& style = "",
                 double size = 1) {
    const auto columns = static_cast<std::size_t>(width / (size * character_width));
    for (const std::string& line : wrapped(words, columns)) {
      y_ += line_height;
      pen_.text({x, y_}, line, style);
      right_ = std::max(right_, x + size * character_width * static_cast<double>(line.size()));
    }
  }

  void add_heading(const std::string& words) {
    y_ += line_height;
    add_words(margin, inner_width_, words, "font-weight=\"bold\"");
  }

  void add_lines(const std::string& heading, const std::vector<ClashPicture::Line>& lines) {
    if (lines.empty()) return;
    add_heading(heading);
    double name_width = 0;
    for (const auto& [name, words] : lines)
      name_width = std::max(name_width, character_width * static_cast<double>(name.size() + 2));
    name_width = std::min(name_width, max_name_width);
    for (const auto& [name, words] : lines) {
      const double top = y_;
      const double right = std::exchange(right_, 0);
      add_words(margin, name_width, name, "fill=\"#555555\"");
      const double end_of_name = y_;
      // Beside the name, or below one that cannot be broken.
      if (right_ <= margin + name_width) y_ = top;
      right_ = std::max(right_, right);
      add_words(margin + name_width, inner_width_ - name_width, words);
      y_ = std::max(y_, end_of_name);
    }
  }

  void add_crossing() {
    add_heading("Without planarity there would be this map");
    const double top = y_ + margin;
    const MapFigure::Marks marks{segments_on(*clash_.crossing),
                                 clash_.crossing->map.segments.size() - 1, clash_.crossing->names};
    figure_->draw(pen_, {margin, top}, marks);
    y_ = top - line_height;
    add_legend(margin + figure_->width() + margin);
    y_ = std::max(y_, top + figure_->height());
  }

  void add_legend(double x) {
    const double y = y_ + line_height - 4.5;
    pen_.line({x, y}, {x + 22, y}, MapFigure::crossing_stroke());
    add_words(x + 34, legend_width - 34,
              fmt::format("the travel to visit {}", clash_.crossing->visit.index()));
    if (!clash_.crossing->loops.empty()) {
      pen_.line({x + 9, y + line_height}, {x + 13, y + line_height}, MapFigure::band_stroke());
      add_words(x + 34, legend_width - 34, "a closed way that it has to cross");
    }
    y_ += line_height / 2;
    std::map<PlaceId, std::string> visits;
    const std::vector<PlaceId>& names = clash_.crossing->names;
    for (const auto& [visit, at] : clash_.crossing->visits) {
      const PlaceId place = names.empty() ? at : names.at(at.index());
      visits[place] += (visits[place].empty() ? "" : ", ") + std::to_string(visit.index());
    }
    for (const auto& [place, numbers] : visits) {
      const bool one = numbers.find(',') == std::string::npos;
      add_words(x, legend_width,
                fmt::format("place {}: visit{} {}", place.index(), one ? "" : "s", numbers));
    }
  }

  const ClashPicture& clash_;
  ClashRow row_;
  std::optional<MapFigure> figure_;
  double inner_width_ = 0;
  double right_ = 0;  ///< end of the longest line
  double y_ = margin;
  SvgPen pen_;
};

}  // namespace

std::string clash_svg(const Trace& trace, const ClashPicture& picture) {
  return Picture(trace, picture).svg();
}

}  // namespace asterism
