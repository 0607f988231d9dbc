#include "drawing/laid_out_drawing.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>

#include "drawing/plane_drawing.hpp"
#include "drawing/quarter_turns.hpp"

namespace asterism {
namespace {

using Point = MapDrawing::Point;

constexpr double gap = 1;  // between pieces

/// Places `first` to before `last`, numbered from 0, with the segments among them: all that a
/// drawing asks for.
TopologicalMap places_of(const TopologicalMap& map, std::size_t first, std::size_t last) {
  TopologicalMap piece;
  for (std::size_t p = first; p < last; ++p) piece.places.push_back(map.places[p]);
  const auto own = [&](PlaceArm arm) {
    return PlaceArm{PlaceId(arm.place.index() - first), arm.arm};
  };
  for (const auto& [one, other] : map.segments)
    if (one.place.index() >= first && one.place.index() < last)
      piece.segments.emplace_back(own(one), own(other));
  return piece;
}

template <class Drawing, class F>
void for_each_point(Drawing& drawing, F f) {
  for (auto& place : drawing.places) f(place);
  for (auto& segment : drawing.segments)
    for (auto& point : segment) f(point);
  for (auto& arms : drawing.arms)
    for (auto& arm : arms) f(arm);
}

/// Adds a piece to the right of what is drawn.
void add(MapDrawing& drawing, MapDrawing piece) {
  double right = -gap;
  for_each_point(drawing, [&](Point& point) { right = std::max(right, point.x); });
  double left = std::numeric_limits<double>::infinity();
  for_each_point(piece, [&](Point& point) { left = std::min(left, point.x); });
  for_each_point(piece, [&](Point& point) { point.x += right + gap - left; });
  std::ranges::move(piece.places, std::back_inserter(drawing.places));
  std::ranges::move(piece.segments, std::back_inserter(drawing.segments));
  std::ranges::move(piece.arms, std::back_inserter(drawing.arms));
  drawing.without_crossings &= piece.without_crossings;
}

}  // namespace

MapDrawing draw_as_laid_out(const TopologicalMap& map, const std::vector<Point>& as) {
  const auto visits = pieces_of(map);
  if (visits.size() <= 1) return turned(draw(map), as);
  if (as.size() != map.places.size())
    throw std::invalid_argument("drawing: found " + std::to_string(as.size()) +
                                " points to turn it by; expected " +
                                std::to_string(map.places.size()));
  MapDrawing drawing;
  drawing.without_crossings = true;
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const std::size_t first = map.visits[visits[i][0]].index();
    const std::size_t last =
        i + 1 < visits.size() ? map.visits[visits[i + 1][0]].index() : map.places.size();
    const auto begin = as.begin() + static_cast<std::ptrdiff_t>(first);
    add(drawing, turned(draw(places_of(map, first, last)),
                        {begin, begin + static_cast<std::ptrdiff_t>(last - first)}));
  }
  return drawing;
}

}  // namespace asterism
