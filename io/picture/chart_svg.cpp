#include "io/picture/chart_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/picture/svg.hpp"

namespace asterism {
namespace {

constexpr double left = 84;
constexpr double right = 150;
constexpr double top = 56;
constexpr double bottom = 56;
constexpr double plot_height = 300;
constexpr std::uint64_t most_on_linear_axis = 1000;
constexpr std::size_t most_labelled_visits = 20;

struct Series {
  const char* name;
  const char* colour;
  const char* marker;  ///< of its points, so that print without colours tells them apart
  const std::vector<std::uint64_t>& values;
};

class Axes {
 public:
  Axes(std::size_t visits, std::uint64_t most)
      : visits_(visits), logarithmic_(most > most_on_linear_axis) {
    if (logarithmic_) {
      for (std::uint64_t tick = 1;; tick *= 10) {
        ticks_.push_back(tick);
        if (tick >= most || tick > UINT64_MAX / 10) break;
      }
    } else {
      // Steps of 1, 2 or 5 times a power of ten, at most six of them.
      std::uint64_t step = 1;
      for (std::size_t i = 0; most > 6 * step; ++i) step = i % 3 == 1 ? step / 2 * 5 : step * 2;
      for (std::uint64_t tick = 0; tick < most + step; tick += step) ticks_.push_back(tick);
    }
    plot_width_ = std::clamp(36.0 * static_cast<double>(visits), 360.0, 900.0);
  }

  double x(std::size_t visit) const {
    const double steps = visits_ > 1 ? static_cast<double>(visits_ - 1) : 1;
    return left + plot_width_ * static_cast<double>(visit) / steps;
  }
  double y(std::uint64_t value) const {
    return top + plot_height * (1 - height(value) / height(ticks_.back()));
  }
  /// Zero has no logarithm: it lies on the axis, with one.
  double height(std::uint64_t value) const {
    if (!logarithmic_) return static_cast<double>(value);
    return std::log10(static_cast<double>(std::max<std::uint64_t>(value, 1)));
  }
  double width() const { return left + plot_width_ + right; }
  double plot_width() const { return plot_width_; }
  const std::vector<std::uint64_t>& ticks() const { return ticks_; }

 private:
  std::size_t visits_;
  bool logarithmic_;
  double plot_width_ = 0;
  std::vector<std::uint64_t> ticks_;
};

std::string text(double x, double y, const std::string& anchor, const std::string& words,
                 const std::string& style = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" {}>{}</text>\n", x, y,
                     anchor, style, xml_text(words));
}

std::string draw_axes(const Axes& axes, std::size_t visits) {
  std::string svg;
  for (const std::uint64_t tick : axes.ticks()) {
    svg += fmt::format(
        "<line x1=\"{0:.1f}\" x2=\"{1:.1f}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" stroke=\"#dddddd\"/>\n",
        left, left + axes.plot_width(), axes.y(tick));
    svg += text(left - 10, axes.y(tick) + 4, "end", std::to_string(tick));
  }
  const std::size_t step = (visits + most_labelled_visits - 1) / most_labelled_visits;
  for (std::size_t visit = 0; visit < visits; visit += step)
    svg += text(axes.x(visit), top + plot_height + 20, "middle", std::to_string(visit));
  svg += text(left + axes.plot_width() / 2, top + plot_height + 44, "middle", "visit");
  svg += fmt::format(
      "<text x=\"22\" y=\"{0:.1f}\" text-anchor=\"middle\" "
      "transform=\"rotate(-90 22 {0:.1f})\">maps that explain the visits so far</text>\n",
      top + plot_height / 2);
  return svg;
}

std::string draw_series(const Axes& axes, const Series& series) {
  std::string points, marks;
  for (std::size_t visit = 0; visit < series.values.size(); ++visit) {
    const double x = axes.x(visit), y = axes.y(series.values[visit]);
    points += fmt::format("{:.1f},{:.1f} ", x, y);
    marks += fmt::format(fmt::runtime(series.marker), x, y, series.colour);
  }
  return fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n{}",
                     points, series.colour, marks);
}

}  // namespace

std::string hypotheses_chart_svg(const std::string& title,
                                 const std::vector<std::uint64_t>& all_per_visit,
                                 const std::vector<std::uint64_t>& planar_per_visit) {
  const Series lists[] = {
      {"all", "#0072b2", "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"3.5\" fill=\"{2}\"/>\n",
       all_per_visit},
      {"planar", "#d55e00", "<path d=\"M{0:.1f} {1:.1f}m-4 4l4 -8l4 8z\" fill=\"{2}\"/>\n",
       planar_per_visit}};
  std::size_t visits = 1;
  std::uint64_t most = 1;
  for (const Series& series : lists) {
    visits = std::max(visits, series.values.size());
    for (const std::uint64_t value : series.values) most = std::max(most, value);
  }
  const Axes axes(visits, most);
  std::string body = text(left, 32, "start", title + ": maps after each visit",
                          "font-size=\"16\" font-weight=\"bold\"");
  body += draw_axes(axes, visits);
  double label_above = -1e9;  // labels of ends that lie close together are moved apart
  for (const Series& series : lists) {
    if (series.values.empty()) continue;
    body += draw_series(axes, series);
    const double y = std::max(axes.y(series.values.back()) + 4, label_above + 18);
    body += text(axes.x(series.values.size() - 1) + 12, y, "start",
                 fmt::format("{}: {}", series.name, series.values.back()),
                 fmt::format("fill=\"{}\" font-weight=\"bold\"", series.colour));
    label_above = y;
  }
  const double height = top + plot_height + bottom;
  return svg_document(axes.width(), height, title, body);
}

}  // namespace asterism
