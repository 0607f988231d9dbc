#include "benchmarks/time_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/picture/map_legend.hpp"
#include "io/picture/svg.hpp"
#include "io/picture/svg_pen.hpp"

namespace asterism {
namespace {

constexpr double left = 62;
constexpr double panel_width = 386;
constexpr double between = 22;
constexpr double right = 14;
constexpr double foot = 16;      // of the picture
constexpr double head = 44;      // of the picture
constexpr double row_head = 50;  // its title, legend and names of panels
constexpr double panel_height = 190;
constexpr double row_foot = 56;  // its ticks
constexpr double inset = 18;     // of the first and the last point of an axis
constexpr double width = left + 2 * panel_width + between + right;

/// Where values are drawn in a panel.
struct Axes {
  double left_x;
  double top_y;
  double least_x, most_x;
  int least_decade, most_decade;

  double x(double value) const {
    const double share = std::log(value / least_x) / std::log(most_x / least_x);
    return left_x + inset + share * (panel_width - 2 * inset);
  }
  double y(double seconds) const {
    const double decades = std::clamp(std::log10(seconds), static_cast<double>(least_decade),
                                      static_cast<double>(most_decade));
    return top_y + panel_height * (most_decade - decades) / (most_decade - least_decade);
  }
};

std::string decade_text(int decade) {
  if (decade >= 0) return fmt::format("{:.0f} s", std::pow(10, decade));
  if (decade >= -3) return fmt::format("{:.0f} ms", std::pow(10, decade + 3));
  return fmt::format("{:.0f} µs", std::pow(10, decade + 6));
}

void draw_mark(SvgPen& pen, SvgPoint at, std::size_t kind, bool is_open) {
  const std::string colour = path_colour(kind);
  const std::string style = fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.6\"",
                                        is_open ? "#ffffff" : colour, colour);
  const std::string start = fmt::format("M{:.1f} {:.1f}", at.x, at.y);
  switch (kind % 4) {
    case 0:
      return pen.circle(at, 4, style);
    case 1:
      return pen.path(start + "m-4.5 3.5l4.5 -8l4.5 8z", style);
    case 2:
      return pen.path(start + "m-3.6 -3.6h7.2v7.2h-7.2z", style);
    default:
      return pen.path(start + "m0 -5l5 5l-5 5l-5 -5z", style);
  }
}

void draw_series(SvgPen& pen, const Axes& axes, const TimeSeries& series, std::size_t kind) {
  std::string line;
  for (const TimePoint& point : series.points) {
    const double x = axes.x(point.x);
    line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? "M" : "L", x, axes.y(point.seconds));
    pen.line({x, axes.y(point.fastest_s)}, {x, axes.y(point.slowest_s)},
             fmt::format("stroke=\"{}\" stroke-width=\"1.2\" opacity=\"0.5\"", path_colour(kind)));
  }
  if (!line.empty())
    pen.path(line,
             fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.8\"", path_colour(kind)));
  for (const TimePoint& point : series.points)
    draw_mark(pen, {axes.x(point.x), axes.y(point.seconds)}, kind, point.is_open);
}

void draw_panel(SvgPen& pen, const Axes& axes, const TimeRow& row, const TimePanel& panel,
                bool has_times) {
  for (int decade = axes.least_decade; decade <= axes.most_decade; ++decade) {
    const double y = axes.y(std::pow(10, decade));
    pen.line({axes.left_x, y}, {axes.left_x + panel_width, y}, "stroke=\"#dddddd\"");
    if (has_times)
      pen.text({axes.left_x - 8, y + 4}, decade_text(decade),
               "text-anchor=\"end\" font-size=\"12\"");
  }
  for (const TimeRow::Tick& tick : row.ticks) {
    const double x = axes.x(tick.x);
    const double bottom = axes.top_y + panel_height;
    pen.line({x, bottom}, {x, bottom + 4}, "stroke=\"#888888\"");
    pen.text({x, bottom + 18}, tick.above, "text-anchor=\"middle\" font-size=\"11\"");
    pen.text({x, bottom + 32}, tick.below, "text-anchor=\"middle\" font-size=\"11\"");
  }
  for (const TimeSeries& series : panel.series) {
    const auto name = std::ranges::find(row.names, series.name);
    draw_series(pen, axes, series, static_cast<std::size_t>(name - row.names.begin()));
  }
  pen.text({axes.left_x, axes.top_y - 8}, panel.title, "font-size=\"12\"");
}

void draw_head(SvgPen& pen, const TimeRow& row, double top_y) {
  pen.text({left, top_y + 14}, row.title, "font-weight=\"bold\" font-size=\"14\"");
  // Names are drawn some pixels a character wide, more or less.
  constexpr double title_character = 7.6;
  constexpr double character = 5.6;
  double x = left + 36 + title_character * static_cast<double>(row.title.size());
  for (std::size_t kind = 0; kind < row.names.size(); ++kind) {
    draw_mark(pen, {x, top_y + 9.5}, kind, false);
    pen.text({x + 10, top_y + 14}, row.names[kind], "font-size=\"12\"");
    x += 36 + character * static_cast<double>(row.names[kind].size());
  }
  for (std::size_t line = 0; line < row.axis.size(); ++line)
    pen.text({left - 8, top_y + row_head + panel_height + 18 + 14 * static_cast<double>(line)},
             row.axis[line], "text-anchor=\"end\" font-size=\"11\"");
}

/// The least and the greatest of all times that are drawn.
std::pair<double, double> times(const std::vector<TimeRow>& rows) {
  double fastest_s = INFINITY;
  double slowest_s = 0;
  for (const TimeRow& row : rows)
    for (const TimePanel& panel : row.panels)
      for (const TimeSeries& series : panel.series)
        for (const TimePoint& point : series.points) {
          fastest_s = std::min(fastest_s, point.fastest_s);
          slowest_s = std::max(slowest_s, point.slowest_s);
        }
  if (fastest_s < slowest_s) return {fastest_s, slowest_s};
  return {0.001, 1};
}

std::pair<double, double> values(const std::vector<TimeRow::Tick>& ticks) {
  const auto [least, most] = std::ranges::minmax(ticks, {}, &TimeRow::Tick::x);
  if (least.x < most.x) return {least.x, most.x};
  return {least.x / 2, most.x * 2};
}

}  // namespace

std::string time_chart_svg(const std::string& title, const std::string& note,
                           const std::vector<TimeRow>& rows) {
  const auto [fastest_s, slowest_s] = times(rows);
  SvgPen pen;
  pen.text({left, 26}, title, "font-size=\"16\" font-weight=\"bold\"");
  double top_y = head;
  for (const TimeRow& row : rows) {
    draw_head(pen, row, top_y);
    const auto [least_x, most_x] = values(row.ticks);
    for (std::size_t i = 0; i < row.panels.size(); ++i) {
      const Axes axes{left + static_cast<double>(i) * (panel_width + between),
                      top_y + row_head,
                      least_x,
                      most_x,
                      static_cast<int>(std::floor(std::log10(fastest_s))),
                      static_cast<int>(std::ceil(std::log10(slowest_s)))};
      draw_panel(pen, axes, row, row.panels[i], i == 0);
    }
    top_y += row_head + panel_height + row_foot;
  }
  pen.text({left, top_y}, note, "font-size=\"12\"");
  return svg_document(width, top_y + foot, title, pen.body());
}

}  // namespace asterism
