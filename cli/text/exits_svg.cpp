#include "cli/text/exits_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/picture/svg.hpp"

namespace asterism {
namespace {

constexpr double margin = 40;
constexpr double letter_width = 8;  ///< of names, at most
constexpr double right = 60;
constexpr double top = 84;
constexpr double bottom = 64;
constexpr double plot_width = 560;
constexpr double row_height = 40;
constexpr double largest_radius = 17;  ///< of what is certain
constexpr double smallest_radius = 2;
constexpr const char* fewer_colour = "#0072b2";
constexpr const char* more_colour = "#d55e00";

/// Numbers of maps from 0 up, ticked in steps of 1, 2 or 5 times a power of ten.
class Axis {
 public:
  Axis(double from_x, std::uint64_t most) : left(from_x) {
    std::uint64_t step = 1;
    for (std::size_t i = 0; most > 6 * step; ++i) step = i % 3 == 1 ? step / 2 * 5 : step * 2;
    for (std::uint64_t tick = 0; tick < most + step; tick += step) ticks_.push_back(tick);
  }
  double x(double maps) const {
    return left + plot_width * maps / static_cast<double>(ticks_.back());
  }
  const std::vector<std::uint64_t>& ticks() const { return ticks_; }

  const double left;

 private:
  std::vector<std::uint64_t> ticks_;
};

std::string text(double x, double y, const char* anchor, const std::string& words,
                 const char* style = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                     anchor, style, xml_text(words));
}

std::string upright(double x, double y_from, double y_to, const char* style) {
  return fmt::format("<path d=\"M{0:.1f} {1:.1f}V{2:.1f}\" {3}/>\n", x, y_from, y_to, style);
}

std::string draw(const Axis& axis, double y, const NamedExit& named, std::uint64_t maps) {
  std::string svg = text(axis.left - 14, y + 5, "end", named.name);
  svg += fmt::format("<path d=\"M{:.1f} {:.1f}h{:.1f}\" stroke=\"#dddddd\"/>\n", axis.left, y,
                     plot_width);
  for (const auto& [seen, maps_left, chance] : named.exit.outlooks) {
    const double radius = std::max(largest_radius * std::sqrt(chance), smallest_radius);
    svg += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\" fill-opacity=\"0.6\">"
        "<title>{}: {} left, {:.0f}%</title></circle>\n",
        axis.x(static_cast<double>(maps_left)), y, radius,
        maps_left <= maps ? fewer_colour : more_colour,
        seen ? xml_text(seen->text()) : "anything else", maps_left, 100 * chance);
  }
  const double expected = axis.x(named.exit.expected_left);
  return svg + upright(expected, y - 12, y + 12, "stroke=\"#222222\" stroke-width=\"2.5\"");
}

}  // namespace

std::string exits_svg(const std::string& title, std::span<const NamedExit> exits,
                      std::uint64_t maps) {
  std::uint64_t most = maps;
  std::size_t longest_name = 0;
  for (const NamedExit& named : exits) {
    longest_name = std::max(longest_name, named.name.size());
    for (const Outlook& outlook : named.exit.outlooks) most = std::max(most, outlook.left);
  }
  const double left = margin + letter_width * static_cast<double>(longest_name);
  const Axis axis(left, most);
  const double end = top + row_height * static_cast<double>(exits.size());

  std::string svg = text(left, 30, "start", title, " font-size=\"17\"");
  svg += text(left, 52, "start",
              "disc: what may be seen there, by its chance; bar: maps expected to be left");
  for (const std::uint64_t tick : axis.ticks()) {
    const double x = axis.x(static_cast<double>(tick));
    svg += upright(x, top, end, "stroke=\"#eeeeee\"");
    svg += text(x, end + 20, "middle", std::to_string(tick));
  }
  svg += text(left + plot_width / 2, end + 44, "middle", "maps left");
  const double now = axis.x(static_cast<double>(maps));
  svg += upright(now, top - 6, end, "stroke=\"#222222\" stroke-dasharray=\"5 4\"");
  svg += text(now, top - 10, "middle", fmt::format("now {}", maps));
  double y = top + row_height / 2;
  for (const NamedExit& named : exits) {
    svg += draw(axis, y, named, maps);
    y += row_height;
  }
  return svg_document(left + plot_width + right, end + bottom, title, svg);
}

}  // namespace asterism
