#include "io/picture/map_page.hpp"

#include <algorithm>

#include "io/picture/svg.hpp"

namespace asterism {
namespace {

constexpr double line_height = 20;
constexpr double character_width = 7.6;  ///< an upper estimate at 13 px, whatever the font
constexpr double legend_width = 300;

std::vector<std::string> lines_of(const std::string& text, double width, double size) {
  return wrapped(text, static_cast<std::size_t>(width / (size * character_width)));
}

}  // namespace

MapPage::MapPage(const std::string& title, double margin, double map_width)
    : title_(title), margin_(margin), legend_x_(3 * margin + map_width), top_(margin) {
  for (const std::string& line : lines_of(title, legend_x_ + legend_width - margin, 1.25)) {
    top_ += line_height;
    pen_.text({margin, top_}, line, "font-size=\"16\" font-weight=\"bold\"");
  }
  legend_y_ = top_ += margin;
}

SvgPoint MapPage::sign() const { return {legend_x_, legend_y_ + line_height - 4.5}; }

void MapPage::add(const std::string& text, double indent, const std::string& style) {
  for (const std::string& line : lines_of(text, legend_width - indent, 1)) {
    legend_y_ += line_height;
    pen_.text({legend_x_ + indent, legend_y_}, line, style);
  }
}

void MapPage::add_gap() { legend_y_ += line_height / 2; }

std::string MapPage::svg(double map_height) const {
  return svg_document(legend_x_ + legend_width + margin_,
                      std::max(top_ + map_height, legend_y_) + margin_, title_, pen_.body());
}

}  // namespace asterism
