#include "io/picture/ssh_map_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "io/picture/map_legend.hpp"
#include "io/picture/map_page.hpp"

namespace asterism {
namespace {

constexpr double pixels_per_unit = 110;
constexpr double margin = 36;
constexpr double disc = 15;
constexpr double between_segments = 34;  ///< of the same places, at their middle

std::string stroke(std::size_t path) {
  return fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"5\"", path_colour(path));
}

/// The line of a segment that bends aside by so much.
std::string curve(SvgPoint from, SvgPoint to, double aside) {
  const double distance = length(to - from);
  if (distance < 1) {  // a loop above the place, each larger than the one before
    const double reach = 3 * disc + std::abs(aside);
    return fmt::format("M{0:.1f} {1:.1f}C{2:.1f} {3:.1f} {4:.1f} {3:.1f} {0:.1f} {1:.1f}", from.x,
                       from.y, from.x - reach, from.y - reach, from.x + reach);
  }
  // A curve passes half as far aside as the point that bends it.
  const SvgPoint bend{(from.x + to.x) / 2 - 2 * aside * (to.y - from.y) / distance,
                      (from.y + to.y) / 2 + 2 * aside * (to.x - from.x) / distance};
  return fmt::format("M{:.1f} {:.1f}Q{:.1f} {:.1f} {:.1f} {:.1f}", from.x, from.y, bend.x, bend.y,
                     to.x, to.y);
}

/// @param pixels  where each place is
void draw_segments(SvgPen& pen, const SshMap& map, const std::vector<SvgPoint>& pixels) {
  // Of segments between the same places, each bends aside by its own distance.
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> between;
  for (const auto& [from, to] : map.segments)
    between[std::minmax(map.places[from.index()].index(), map.places[to.index()].index())]
        .push_back(map.paths[from.index()].path.index());
  for (const auto& [ends, paths] : between)
    for (std::size_t i = 0; i < paths.size(); ++i)
      pen.path(curve(pixels[ends.first], pixels[ends.second],
                     between_segments *
                         (static_cast<double>(i) - (static_cast<double>(paths.size()) - 1) / 2)),
               stroke(paths[i]));
}

void draw_places(SvgPen& pen, const SshMap& map, const std::vector<SvgPoint>& pixels) {
  const std::size_t robot = map.places[map.dstates.back().index()].index();
  for (std::size_t place = 0; place < pixels.size(); ++place) {
    pen.circle(pixels[place], disc,
               fmt::format("fill=\"#ffffff\" stroke=\"#222222\" stroke-width=\"{}\"",
                           place == robot ? 5 : 2));
    pen.text(pixels[place] + SvgPoint{0, 4.5}, std::to_string(place), "text-anchor=\"middle\"");
  }
}

void add_legend(MapPage& page, const SshMap& map) {
  page.add_heading("Paths, with their places");
  for (std::size_t path = 0; path < map.number_of_paths(); ++path) {
    std::set<std::size_t> on;
    for (std::size_t d = 0; d < map.paths.size(); ++d)
      if (map.paths[d].path.index() == path) on.insert(map.places[d].index());
    const auto [x, y] = page.sign();
    page.pen().path(fmt::format("M{:.1f} {:.1f}H{:.1f}", x, y, x + 22), stroke(path));
    page.add(fmt::format("{}: {}", path, fmt::join(on, ", ")), 30);
  }
  page.add_gap();
  page.add_heading("Places, with the views seen there");
  for (std::size_t place = 0; place < map.number_of_places(); ++place) {
    std::vector<std::size_t> views;
    for (std::size_t k = 0; k < map.dstates.size(); ++k)
      if (map.places[map.dstates[k].index()].index() == place) views.push_back(k);
    page.add(fmt::format("place {}: view{} {}", place, views.size() == 1 ? "" : "s",
                         fmt::join(views, ", ")));
  }
  page.add_gap();
  page.add("The robot is at the place with the thick ring.");
}

}  // namespace

std::string ssh_map_svg(const SshMap& map, const std::vector<MapDrawing::Point>& places,
                        const std::string& title) {
  if (places.size() != map.number_of_places() || places.empty())
    throw std::invalid_argument("not a point for each place");
  const auto [left, right] = std::ranges::minmax(places, {}, &SvgPoint::x);
  const auto [low, high] = std::ranges::minmax(places, {}, &SvgPoint::y);
  MapPage page(title, margin, pixels_per_unit * (right.x - left.x));
  std::vector<SvgPoint> pixels;
  for (const auto& [x, y] : places)
    pixels.push_back(
        {margin + pixels_per_unit * (x - left.x), page.top() + pixels_per_unit * (high.y - y)});
  draw_segments(page.pen(), map, pixels);
  draw_places(page.pen(), map, pixels);
  add_legend(page, map);
  return page.svg(pixels_per_unit * (high.y - low.y));
}

}  // namespace asterism
