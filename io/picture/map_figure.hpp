#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/map_drawing.hpp"
#include "core/topological_map.hpp"
#include "io/path_of_arm.hpp"
#include "io/picture/svg_pen.hpp"

namespace asterism {

/// A drawing of a map as part of a picture, its upper left corner anywhere.
class MapFigure {
 public:
  /// What stands out.
  struct Marks {
    std::set<std::size_t> banded = {};         ///< segments on a broad pale band
    std::optional<std::size_t> crossing = {};  ///< a segment in red, on top of all others
    std::vector<PlaceId> names = {};  ///< place p is shown as names[p]; as p if there are none
  };

  /// @pre both outlive the figure; the map has a place
  MapFigure(const TopologicalMap& map, const MapDrawing& drawing);

  double width() const;
  double height() const;
  /// Segments, open arms and numbered places.
  void draw(SvgPen& pen, SvgPoint corner, const Marks& marks);
  /// The robot where it is after the last visit.  @pre draw() has been called
  void draw_robot(SvgPen& pen) const;

  static std::string stroke(std::size_t path, const char* more = "");
  /// A straight piece of a path's line, with the stripe that tells it from others of its colour.
  static void draw_path_line(SvgPen& pen, SvgPoint from, SvgPoint to, std::size_t path);
  static std::string crossing_stroke();
  static std::string band_stroke();
  static void draw_robot_arrow(SvgPen& pen, SvgPoint centre, SvgPoint along);

 private:
  static std::string stripe(std::size_t path);
  SvgPoint pixel(MapDrawing::Point point) const;
  std::pair<SvgPoint, SvgPoint> pixels(PlaceArm arm) const;
  void draw_segment(SvgPen& pen, std::size_t segment, const Marks& marks) const;
  void draw_arm(SvgPen& pen, PlaceArm arm, std::size_t path) const;
  void draw_place(SvgPen& pen, std::size_t p, const Marks& marks) const;

  const TopologicalMap& map_;
  const MapDrawing& drawing_;
  PathOfArm paths_;
  MapDrawing::Point low_, high_;
  SvgPoint corner_;
};

}  // namespace asterism
