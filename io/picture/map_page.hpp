#pragma once

#include <string>

#include "io/picture/svg_pen.hpp"

namespace asterism {

/// A picture of a map of either kind under its title, with a legend to the right.
class MapPage {
 public:
  /// @param margin     round all of it
  /// @param map_width  of the map, to be drawn with its upper left corner at {margin, top()}
  MapPage(const std::string& title, double margin, double map_width);

  SvgPen& pen() { return pen_; }
  double top() const { return top_; }
  /// Where a sign stands in the legend's next line: its left end, at half the letters' height.
  SvgPoint sign() const;
  /// Adds a line to the legend, or as many as the text needs.
  void add(const std::string& text, double indent = 0, const std::string& style = "");
  void add_heading(const std::string& text) { add(text, 0, "font-weight=\"bold\""); }
  /// Adds half an empty line to the legend.
  void add_gap();
  /// All of it as a standalone SVG 1.1.
  std::string svg(double map_height) const;

 private:
  std::string title_;
  double margin_;
  double legend_x_;
  double top_;
  double legend_y_;
  SvgPen pen_;
};

}  // namespace asterism
