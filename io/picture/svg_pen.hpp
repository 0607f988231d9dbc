#pragma once

#include <string>
#include <vector>

#include "core/map_drawing.hpp"

namespace asterism {

using SvgPoint = MapDrawing::Point;  ///< in a picture: pixels, y down

// Points as vectors.
SvgPoint operator+(SvgPoint a, SvgPoint b);
SvgPoint operator-(SvgPoint a, SvgPoint b);
SvgPoint operator*(double factor, SvgPoint a);
/// How long a vector is.
double length(SvgPoint a);
/// The point `pixels` away from one point in the direction of another.
SvgPoint towards(SvgPoint from, SvgPoint to, double pixels);

/// Draws a picture's parts one over the other.
class SvgPen {
 public:
  void text(SvgPoint at, const std::string& text, const std::string& style = "");
  void line(SvgPoint from, SvgPoint to, const std::string& style);
  void path(const std::string& d, const std::string& style);
  void circle(SvgPoint centre, double radius, const std::string& style);
  /// A filled arrowhead.
  void arrow(SvgPoint tip, SvgPoint along, double length, double half_width,
             const std::string& style);

  const std::string& body() const { return body_; }

 private:
  std::string body_;
};

/// Attribute `d` of a line of straight pieces with rounded corners.
std::string rounded(const std::vector<SvgPoint>& line, double radius);

}  // namespace asterism
