#include "io/picture/svg_pen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/picture/svg.hpp"

namespace asterism {

SvgPoint operator+(SvgPoint a, SvgPoint b) { return {a.x + b.x, a.y + b.y}; }
SvgPoint operator-(SvgPoint a, SvgPoint b) { return {a.x - b.x, a.y - b.y}; }
SvgPoint operator*(double factor, SvgPoint a) { return {factor * a.x, factor * a.y}; }
double length(SvgPoint a) { return std::hypot(a.x, a.y); }

SvgPoint towards(SvgPoint from, SvgPoint to, double pixels) {
  return from + (pixels / length(to - from)) * (to - from);
}

void SvgPen::text(SvgPoint at, const std::string& text, const std::string& style) {
  body_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", at.x, at.y, style,
                       xml_text(text));
}

void SvgPen::line(SvgPoint from, SvgPoint to, const std::string& style) {
  path(fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}", from.x, from.y, to.x, to.y), style);
}

void SvgPen::path(const std::string& d, const std::string& style) {
  body_ += fmt::format("<path d=\"{}\" {}/>\n", d, style);
}

void SvgPen::circle(SvgPoint centre, double radius, const std::string& style) {
  body_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" {}/>\n", centre.x, centre.y,
                       radius, style);
}

void SvgPen::arrow(SvgPoint tip, SvgPoint along, double length, double half_width,
                   const std::string& style) {
  const SvgPoint aside{-along.y, along.x};
  const SvgPoint left = tip - length * along + half_width * aside;
  const SvgPoint right = tip - length * along - half_width * aside;
  path(fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z", tip.x, tip.y, left.x, left.y,
                   right.x, right.y),
       style);
}

std::string rounded(const std::vector<SvgPoint>& line, double radius) {
  std::string d = fmt::format("M{:.1f} {:.1f}", line.front().x, line.front().y);
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const double r =
        std::min({radius, length(line[i] - line[i - 1]) / 2, length(line[i + 1] - line[i]) / 2});
    const SvgPoint before = towards(line[i], line[i - 1], r);
    const SvgPoint after = towards(line[i], line[i + 1], r);
    d += fmt::format("L{:.1f} {:.1f}Q{:.1f} {:.1f} {:.1f} {:.1f}", before.x, before.y, line[i].x,
                     line[i].y, after.x, after.y);
  }
  return d + fmt::format("L{:.1f} {:.1f}", line.back().x, line.back().y);
}

}  // namespace asterism
