#include "io/picture/plan_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "io/grid/png_image.hpp"
#include "io/picture/svg.hpp"

namespace asterism {
namespace {

constexpr double disc_px = 11;
constexpr double foot_px = 24;   ///< for the scale bar
constexpr double stray = 0.002;  ///< share of a grid's known cells that may lie off at each side
constexpr double chi_squared_95 = 5.991;  ///< of two degrees of freedom
constexpr double unknown_grey = 232;
constexpr double wall_grey = 24;
constexpr const char* unknown_colour = "#e8e8e8";
constexpr const char* ink = "#1d2530";

/// A floor plan's greys, in few steps, so that the picture packs well.
std::uint8_t plan_grey(float log_odds) {
  constexpr double steps = 8;
  const double lean = std::tanh(static_cast<double>(log_odds) / 2);  // 2 p - 1
  const double shade = std::round(std::abs(lean) * steps) / steps;
  const double end = log_odds > 0 ? wall_grey : 255;
  return static_cast<std::uint8_t>(std::lround(unknown_grey + shade * (end - unknown_grey)));
}

/// Columns and rows of a grid, from first to one behind the last.
struct CellBox {
  Cell first;
  Cell end;
};

/// The range of counts' indices without the `most` outermost at either side.
std::pair<int, int> trimmed(const std::vector<std::size_t>& counts, std::size_t most) {
  int first = 0;
  int end = static_cast<int>(counts.size());
  const auto count = [&](int i) { return counts[static_cast<std::size_t>(i)]; };
  for (std::size_t cut = 0; first < end && (cut += count(first)) <= most;) ++first;
  for (std::size_t cut = 0; first < end && (cut += count(end - 1)) <= most;) --end;
  return {first, end};
}

std::optional<CellBox> known_cells(const Grid& grid, double stray_share) {
  std::vector<std::size_t> columns(static_cast<std::size_t>(grid.width));
  std::vector<std::size_t> rows(static_cast<std::size_t>(grid.height));
  std::size_t known = 0;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t column = 0; column < columns.size(); ++column) {
      if (grid.log_odds[row * columns.size() + column] == 0) continue;
      ++columns[column];
      ++rows[row];
      ++known;
    }
  }
  if (known == 0) return std::nullopt;
  const auto most = static_cast<std::size_t>(stray_share * static_cast<double>(known));
  const auto [left, right] = trimmed(columns, most);
  const auto [bottom, top] = trimmed(rows, most);
  return CellBox{{left, bottom}, {right, top}};
}

/// 1, 2 or 5 times a power of ten, at most that.
double round_below(double length_m) {
  const double power = std::pow(10, std::floor(std::log10(length_m)));
  for (const double step : {5.0, 2.0}) {
    if (step * power <= length_m) return step * power;
  }
  return power;
}

std::string line(Point2 from, Point2 to, const std::string& style) {
  return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" {}/>\n", from.x_m, from.y_m, to.x_m,
                     to.y_m, style);
}

}  // namespace

void PlanBounds::include(Point2 point, double margin_m) {
  const Point2 margin{margin_m, margin_m};
  const Point2 low = point - margin;
  const Point2 high = point + margin;
  low_ = is_empty_ ? low : Point2{std::min(low_.x_m, low.x_m), std::min(low_.y_m, low.y_m)};
  high_ = is_empty_ ? high : Point2{std::max(high_.x_m, high.x_m), std::max(high_.y_m, high.y_m)};
  is_empty_ = false;
}

void PlanBounds::include(const Grid& grid) {
  const std::optional<CellBox> box = known_cells(grid, stray);
  if (!box) return;
  for (const int column : {box->first.column, box->end.column}) {
    for (const int row : {box->first.row, box->end.row}) {
      include(grid.frame_from_grid * Point2{column * grid.resolution_m, row * grid.resolution_m});
    }
  }
}

PlanPicture::PlanPicture(const PlanBounds& shown, double max_width_px, double max_height_px)
    : low_(shown.low()) {
  const double wide_m = std::max(shown.high().x_m - low_.x_m, 0.1);
  const double high_m = std::max(shown.high().y_m - low_.y_m, 0.1);
  px_per_m_ = std::min(max_width_px / wide_m, max_height_px / high_m);
  width_px_ = px_per_m_ * wide_m;
  height_px_ = plan_height_px_ = px_per_m_ * high_m;
}

Point2 PlanPicture::pixel(Point2 in_page) const {
  return {px_per_m_ * (in_page.x_m - low_.x_m),
          plan_height_px_ - px_per_m_ * (in_page.y_m - low_.y_m)};
}

void PlanPicture::add_grid(const Grid& grid, const Pose2& page_from_frame, double opacity) {
  const std::optional<CellBox> known = known_cells(grid, 0);
  if (!known) return;
  // No more of it than can be seen: the box of the picture's corners, in cells.
  const Pose2 page_from_grid = page_from_frame * grid.frame_from_grid;
  const Pose2 grid_from_page = inverse(page_from_grid);
  PlanBounds seen;
  for (const double x_m : {0.0, width_px_ / px_per_m_}) {
    for (const double y_m : {0.0, plan_height_px_ / px_per_m_}) {
      seen.include(grid_from_page * (low_ + Point2{x_m, y_m}));
    }
  }
  const auto cell = [&](double metres, int low, int high) {
    return static_cast<int>(std::clamp(std::floor(metres / grid.resolution_m),
                                       static_cast<double>(low), static_cast<double>(high)));
  };
  const CellBox box{
      {cell(seen.low().x_m, known->first.column, known->end.column),
       cell(seen.low().y_m, known->first.row, known->end.row)},
      {cell(seen.high().x_m + grid.resolution_m, known->first.column, known->end.column),
       cell(seen.high().y_m + grid.resolution_m, known->first.row, known->end.row)}};
  if (box.end.column <= box.first.column || box.end.row <= box.first.row) return;
  const GreyImage image = picture_of(grid, box.first, box.end, plan_grey);
  const auto corner = [&](int column, int row) {
    return pixel(page_from_grid * Point2{column * grid.resolution_m, row * grid.resolution_m});
  };
  const Point2 origin = corner(box.first.column, box.end.row);
  const Point2 along = corner(box.first.column + 1, box.end.row) - origin;
  const Point2 down = corner(box.first.column, box.end.row - 1) - origin;
  body_ += fmt::format(
      "<image width=\"{}\" height=\"{}\" {}preserveAspectRatio=\"none\" "
      "transform=\"matrix({:.6f} {:.6f} {:.6f} {:.6f} {:.3f} {:.3f})\" href=\"{}\"/>\n",
      image.width, image.height, opacity < 1 ? fmt::format("opacity=\"{:g}\" ", opacity) : "",
      along.x_m, along.y_m, down.x_m, down.y_m, origin.x_m, origin.y_m,
      data_uri("image/png", png(image)));
}

void PlanPicture::add_line(std::span<const Point2> points, const std::string& style) {
  if (points.empty()) return;
  constexpr double apart_px = 1.5;
  std::string text;
  Point2 last{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point2 at = pixel(points[i]);
    if (i > 0 && i + 1 < points.size() && norm(at - last) < apart_px) continue;
    text += fmt::format("{}{:.1f},{:.1f}", i == 0 ? "" : " ", at.x_m, at.y_m);
    last = at;
  }
  body_ += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke-linejoin=\"round\" {}/>\n",
                       text, style);
}

void PlanPicture::add_gateway(const Gateway& gateway) {
  const Point2 out = unit_vector(gateway.outward_rad);
  const Point2 half = (gateway.width_m / 2) * left_of(out);
  const Point2 left = pixel(gateway.middle + half);
  const Point2 right = pixel(gateway.middle - half);
  body_ += line(left, right, "stroke=\"#ffffff\" stroke-width=\"6\" stroke-linecap=\"round\"");
  body_ += line(
      left, right,
      fmt::format("stroke=\"{}\" stroke-width=\"3\" stroke-linecap=\"round\"", gateway.colour));
  if (!gateway.is_open) return;
  const Point2 middle = pixel(gateway.middle);
  body_ += line(
      middle, middle + 15 * Point2{out.x_m, -out.y_m},
      fmt::format("stroke=\"{}\" stroke-width=\"3\" stroke-dasharray=\"4 3\"", gateway.colour));
}

void PlanPicture::add_label_ahead(const Gateway& gateway, const std::string& label) {
  const auto [middle, out, left] = seen(gateway);
  const double half_px = gateway.width_m / 2 * px_per_m_;
  add_label({middle + 13 * out, middle + 24 * out, middle + (half_px + 11) * left,
             middle - (half_px + 11) * left},
            gateway.colour, label);
}

void PlanPicture::add_label_beside(const Gateway& gateway, const std::string& label) {
  const auto [middle, out, left] = seen(gateway);
  const double half_px = gateway.width_m / 2 * px_per_m_;
  std::vector<Point2> spots;
  for (const double gap_px : {11.0, 20.0})
    for (const double ahead_px : {0.0, 12.0, -12.0})
      for (const double side : {1.0, -1.0})
        spots.push_back(middle + (side * (half_px + gap_px)) * left + ahead_px * out);
  add_label(spots, gateway.colour, label);
}

void PlanPicture::add_ellipse(const Pose2& page_from_place, const PoseCovariance& covariance) {
  const double ahead = covariance[0];
  const double left = covariance[4];
  const double both = (covariance[1] + covariance[3]) / 2;
  const double middle = (ahead + left) / 2;
  const double spread = std::hypot((ahead - left) / 2, both);
  const double turn_rad = std::atan2(2 * both, ahead - left) / 2 + page_from_place.heading_rad;
  const auto radius_px = [&](double variance) {
    return px_per_m_ * std::sqrt(chi_squared_95 * std::max(variance, 0.0));
  };
  const Point2 at = pixel(page_from_place.position());
  body_ += fmt::format(
      "<ellipse rx=\"{:.2f}\" ry=\"{:.2f}\" transform=\"translate({:.1f} {:.1f}) rotate({:.1f})\" "
      "fill=\"#d55e00\" fill-opacity=\"0.18\" stroke=\"#d55e00\" stroke-width=\"1.2\"/>\n",
      radius_px(middle + spread), radius_px(middle - spread), at.x_m, at.y_m,
      -turn_rad * 180 / std::numbers::pi);
}

void PlanPicture::add_place(Point2 at, std::size_t number,
                            const std::vector<Direction>& directions) {
  const Point2 centre = pixel(at);
  const std::string circle =
      fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\"", centre.x_m, centre.y_m);
  body_ += fmt::format("{} r=\"{}\" fill=\"#ffffff\"/>\n", circle, disc_px);
  take(centre, disc_px + 1);
  for (const Direction& direction : directions) {
    const Point2 out = unit_vector(direction.heading_rad);
    body_ += line(centre, centre + disc_px * Point2{out.x_m, -out.y_m},
                  fmt::format("stroke=\"{}\" stroke-width=\"5\"", direction.colour));
  }
  body_ += fmt::format("{} r=\"{}\" fill=\"none\" stroke=\"#1d2530\" stroke-width=\"1.6\"/>\n",
                       circle, disc_px);
  body_ += fmt::format("{} r=\"{}\" fill=\"#ffffff\"/>\n", circle, disc_px - 2.8);
  body_ += fmt::format(
      "<text class=\"place\" x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" font-weight=\"bold\" "
      "text-anchor=\"middle\" fill=\"#1d2530\">{}</text>\n",
      centre.x_m, centre.y_m + 4, number < 100 ? 11.5 : 8.5, number);
}

void PlanPicture::add_dead_end(Point2 place, const Direction& direction) {
  const Point2 out = unit_vector(direction.heading_rad);
  const Point2 along{out.x_m, -out.y_m};
  const Point2 centre = pixel(place);
  const Point2 end = centre + (disc_px + 8) * along;
  const std::string style = fmt::format("stroke=\"{}\" stroke-width=\"3\"", direction.colour);
  body_ += line(centre + disc_px * along, end, style);
  body_ += line(end + 6 * left_of(along), end - 6 * left_of(along), "class=\"dead-end\" " + style);
  take(end, 7);
}

void PlanPicture::add_start(Point2 at) {
  const Point2 spot = pixel(at);
  body_ += fmt::format(
      "<circle class=\"start\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\" "
      "stroke=\"#ffffff\" stroke-width=\"1.5\"/>\n",
      spot.x_m, spot.y_m, ink);
  take(spot, 4);
}

void PlanPicture::add_label_at(Point2 at, const std::string& label) {
  const Point2 spot = pixel(at);
  std::vector<Point2> spots;
  for (const double away : {1.0, 1.7, 2.5})
    for (const Point2 towards : {Point2{0, -12}, Point2{0, 12}, Point2{24, 0}, Point2{-24, 0}})
      spots.push_back(spot + away * towards);
  add_label(spots, ink, label);
}

void PlanPicture::add_robot(const Pose2& page_from_robot) {
  const Point2 spot = pixel(page_from_robot.position());
  const Point2 out = unit_vector(page_from_robot.heading_rad);
  const Point2 along{out.x_m, -out.y_m};
  const Point2 tip = spot + 10 * along;
  const Point2 one = spot - 6 * along + 7 * left_of(along);
  const Point2 other = spot - 6 * along - 7 * left_of(along);
  body_ += fmt::format(
      "<path class=\"robot\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\" fill=\"#1d2530\" "
      "stroke=\"#ffffff\" stroke-width=\"1.5\"/>\n",
      tip.x_m, tip.y_m, one.x_m, one.y_m, other.x_m, other.y_m);
  take(spot, 9);
}

void PlanPicture::add_scale_bar() {
  const double length_m = round_below(0.25 * width_px_ / px_per_m_);
  const double y = plan_height_px_ + 14;
  const double end = 2 + px_per_m_ * length_m;
  body_ += fmt::format(
      "<path class=\"scale\" d=\"M2 {:.1f}v8m0 -4H{:.1f}m0 -4v8\" fill=\"none\" "
      "stroke=\"#1d2530\" stroke-width=\"1.5\"/>\n"
      "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"12\" fill=\"#1d2530\">{:g} m</text>\n",
      y - 4, end, end + 7, y + 4, length_m);
  height_px_ = plan_height_px_ + foot_px;
}

PlanPicture::Seen PlanPicture::seen(const Gateway& gateway) const {
  const Point2 out = unit_vector(gateway.outward_rad);
  return {pixel(gateway.middle), {out.x_m, -out.y_m}, {-out.y_m, -out.x_m}};
}

void PlanPicture::take(Point2 at_px, double reach_px) {
  const Point2 reach{reach_px, reach_px};
  taken_.push_back({at_px - reach, at_px + reach});
}

/// How much of a box lies on what is taken, or out of the picture.
double PlanPicture::taken_px2(const Box& box) const {
  const auto shared_px2 = [&](const Box& other) {
    const Point2 low{std::max(box.low.x_m, other.low.x_m), std::max(box.low.y_m, other.low.y_m)};
    const Point2 high{std::min(box.high.x_m, other.high.x_m),
                      std::min(box.high.y_m, other.high.y_m)};
    return std::max(0.0, high.x_m - low.x_m) * std::max(0.0, high.y_m - low.y_m);
  };
  const Point2 size = box.high - box.low;
  double sum_px2 = size.x_m * size.y_m - shared_px2({{0, 0}, {width_px_, plan_height_px_}});
  for (const Box& other : taken_) sum_px2 += shared_px2(other);
  return sum_px2;
}

/// At the first of the spots that is free, or at that of which least is taken; nowhere if that is
/// too much to be read.
void PlanPicture::add_label(const std::vector<Point2>& spots_px, const std::string& colour,
                            const std::string& label) {
  constexpr double size_px = 11;
  const Point2 half{0.31 * size_px * static_cast<double>(label.size()), 0.5 * size_px};
  const auto box = [&](Point2 spot) { return Box{spot - half, spot + half}; };
  const Point2 at_px = *std::ranges::min_element(
      spots_px, {}, [&](Point2 spot) { return std::round(taken_px2(box(spot))); });
  constexpr double most_taken = 0.3;
  if (taken_px2(box(at_px)) > most_taken * 4 * half.x_m * half.y_m) return;
  taken_.push_back(box(at_px));
  body_ += fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" font-weight=\"bold\" "
      "text-anchor=\"middle\" fill=\"{}\" stroke=\"#ffffff\" stroke-width=\"3\" "
      "paint-order=\"stroke\" stroke-linejoin=\"round\">{}</text>\n",
      at_px.x_m, at_px.y_m + 0.36 * size_px, size_px, colour, xml_text(label));
}

std::string PlanPicture::svg(const std::string& title) const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0 {0:.1f} {1:.1f}\" "
      "style=\"max-width:{0:.0f}px\">\n<title>{2}</title>\n"
      "<rect width=\"{0:.1f}\" height=\"{3:.1f}\" fill=\"{4}\"/>\n{5}</svg>\n",
      width_px_, height_px_, xml_text(title), plan_height_px_, unknown_colour, body_);
}

}  // namespace asterism
