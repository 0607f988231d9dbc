#include "io/picture/place_svg.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/grid/grid_file.hpp"
#include "io/grid/png_image.hpp"
#include "io/picture/svg.hpp"

namespace asterism {
namespace {

constexpr double place_px = 600;         // side of one place's picture
constexpr double thumb_px = 220;         // ... in the strip
constexpr double head_px = 28;           // the title's line
constexpr std::size_t thumbs_a_row = 5;  // pictures in a row of the strip
constexpr double way_px = 720;

std::string map_image(const Grid& map, double side_px) {
  return fmt::format(
      "<image width=\"{0:.0f}\" height=\"{0:.0f}\" preserveAspectRatio=\"none\" "
      "style=\"image-rendering:pixelated\" "
      "href=\"{1}\"/>\n",
      side_px, data_uri("image/png", png(picture_of(map, grey_of_log_odds))));
}

// From the frame to the picture: the grid fills a square, +y up.
class Screen {
 public:
  Screen(const Grid& map, double side_px)
      : grid_from_frame_(inverse(map.frame_from_grid)),
        px_per_m_(side_px / (std::max(map.width, map.height) * map.resolution_m)),
        side_px_(side_px) {}

  double length(double metres) const { return metres * px_per_m_; }
  Point2 operator()(Point2 in_frame) const {
    const Point2 at = grid_from_frame_ * in_frame;
    return {at.x_m * px_per_m_, side_px_ - at.y_m * px_per_m_};
  }

 private:
  Pose2 grid_from_frame_;
  double px_per_m_;
  double side_px_;
};

std::string dots(const Screen& screen, const std::vector<Point2>& points, double radius_px,
                 const char* colour) {
  std::string path;
  for (const Point2 point : points) {
    const Point2 at = screen(point);
    path += fmt::format("M{:.1f} {:.1f}h0", at.x_m, at.y_m);
  }
  return path.empty() ? path
                      : fmt::format(
                            "<path d=\"{}\" stroke=\"{}\" stroke-width=\"{:.1f}\" "
                            "stroke-linecap=\"round\"/>\n",
                            path, colour, 2 * radius_px);
}

std::string line(Point2 from, Point2 to, const char* style) {
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n",
                     from.x_m, from.y_m, to.x_m, to.y_m, style);
}

std::string way_line(const std::vector<Point2>& points, const char* style) {
  std::string text;
  for (const Point2 at : points) text += fmt::format("{:.1f},{:.1f} ", at.x_m, at.y_m);
  return fmt::format("<polyline points=\"{}\" fill=\"none\" {}/>\n", text, style);
}

std::string arm(const Screen& screen, const PlacePicture::Arm& arm) {
  const Point2 out = unit_vector(arm.outward_rad);
  const Point2 left = left_of(out);
  const double reach_m = arm.width_m ? 1.5 : 3.5;
  const Point2 tail = screen(arm.from);
  const Point2 head = screen(arm.from + reach_m * out);
  std::string text;
  if (arm.width_m) {
    text +=
        line(screen(arm.from + (*arm.width_m / 2) * left),
             screen(arm.from - (*arm.width_m / 2) * left), "stroke=\"#1040c0\" stroke-width=\"3\"");
    text += line(tail, head, "stroke=\"#1040c0\" stroke-width=\"2\"");
    for (const double side : {0.5, -0.5}) {
      text += line(head, screen(arm.from + (reach_m - 0.5) * out + (side * 0.6) * left),
                   "stroke=\"#1040c0\" stroke-width=\"2\"");
    }
  } else {
    text += line(tail, head, "stroke=\"#1040c0\" stroke-width=\"1.5\" stroke-dasharray=\"3 4\"");
  }
  const Point2 label = screen(arm.from + (reach_m + 0.8) * out);
  return text + fmt::format(
                    "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" font-size=\"16\" "
                    "font-weight=\"bold\" fill=\"#1040c0\" stroke=\"#ffffff\" "
                    "stroke-width=\"4\" paint-order=\"stroke\">{}</text>\n",
                    label.x_m, label.y_m + 5, xml_text(arm.label));
}

std::string drawn(const PlacePicture& picture, double side_px) {
  const Screen screen(picture.map, side_px);
  std::string body = map_image(picture.map, side_px);
  std::vector<Point2> way;
  for (const Point2 point : picture.way) way.push_back(screen(point));
  if (!way.empty()) body += way_line(way, "stroke=\"#e08000\" stroke-width=\"1.5\"");
  body += dots(screen, picture.skeleton, 1, "#60a0ff");
  body += dots(screen, picture.pruned, 1.4, "#d00000");
  for (const PlacePicture::Disc& disc : picture.core) {
    const Point2 at = screen(disc.middle);
    body += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"none\" stroke=\"#009030\"/>\n",
        at.x_m, at.y_m, screen.length(disc.radius_m));
  }
  for (const PlacePicture::Arm& each : picture.arms) body += arm(screen, each);
  return body;
}

// A picture under its title, its contents cut at the frame.
std::string framed(const PlacePicture& picture, const std::string& title, Point2 at, double side_px,
                   std::size_t number) {
  return fmt::format(
      "<g transform=\"translate({0:.0f} {1:.0f})\">\n<text x=\"4\" y=\"18\">{2}</text>\n"
      "<g transform=\"translate(0 {3:.0f})\"><clipPath id=\"frame-{4}\"><rect width=\"{5:.0f}\" "
      "height=\"{5:.0f}\"/></clipPath>\n<g clip-path=\"url(#frame-{4})\">\n"
      "<g transform=\"scale({6:.4f})\">\n{7}</g></g></g></g>\n",
      at.x_m, at.y_m, xml_text(title), head_px, number, side_px, side_px / place_px,
      drawn(picture, place_px));
}

}  // namespace

std::string place_svg(const PlacePicture& picture) {
  return svg_document(place_px, place_px + head_px, picture.title,
                      framed(picture, picture.title, {}, place_px, 0));
}

std::string strip_svg(const std::vector<PlacePicture>& pictures, const std::string& title) {
  std::string body;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    // There is room for what stands before the star.
    body += framed(pictures[i], pictures[i].title.substr(0, pictures[i].title.find(':')),
                   {static_cast<double>(i % thumbs_a_row) * (thumb_px + 10),
                    static_cast<double>(i / thumbs_a_row) * (thumb_px + head_px + 10)},
                   thumb_px, i);
  }
  const auto across = static_cast<double>(std::min(pictures.size(), thumbs_a_row));
  const auto rows = static_cast<double>((pictures.size() + thumbs_a_row - 1) / thumbs_a_row);
  return svg_document(std::max(1.0, across) * (thumb_px + 10),
                      std::max(1.0, rows) * (thumb_px + head_px + 10), title, body);
}

std::string way_svg(const std::vector<Point2>& way, const std::vector<NumberedPoint>& visits,
                    const std::string& title) {
  Point2 low;
  Point2 high;
  for (const Point2 point : way) {
    low = {std::min(low.x_m, point.x_m), std::min(low.y_m, point.y_m)};
    high = {std::max(high.x_m, point.x_m), std::max(high.y_m, point.y_m)};
  }
  const double span_m = std::max({high.x_m - low.x_m, high.y_m - low.y_m, 1.0});
  const double scale = way_px / (1.1 * span_m);
  const auto on_screen = [&](Point2 point) {
    return Point2{(point.x_m - low.x_m + 0.05 * span_m) * scale,
                  (high.y_m - point.y_m + 0.05 * span_m) * scale + head_px};
  };
  std::vector<Point2> points;
  for (const Point2 point : way) points.push_back(on_screen(point));
  std::string body = fmt::format("<text x=\"6\" y=\"18\">{}</text>\n", xml_text(title));
  body += way_line(points, "stroke=\"#e08000\" stroke-width=\"1.5\"");
  for (const NumberedPoint& visit : visits) {
    const Point2 at = on_screen(visit.at);
    body += fmt::format(
        "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"11\" fill=\"#ffffff\" stroke=\"#1040c0\"/>"
        "<text x=\"{0:.1f}\" y=\"{2:.1f}\" text-anchor=\"middle\">{3}</text>\n",
        at.x_m, at.y_m, at.y_m + 4.5, visit.number);
  }
  // Ten metres, for scale.
  const double foot = (high.y_m - low.y_m + 0.1 * span_m) * scale + head_px;
  body += line({20, foot}, {20 + 10 * scale, foot}, "stroke=\"#222222\" stroke-width=\"2\"");
  body += fmt::format("<text x=\"24\" y=\"{:.1f}\">10 m</text>\n", foot - 6);
  return svg_document((high.x_m - low.x_m + 0.1 * span_m) * scale, foot + 16, title, body);
}

}  // namespace asterism
