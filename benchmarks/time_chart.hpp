#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace asterism {

/// A time that was measured.
struct TimePoint {
  double x = 0;
  double seconds = 0;
  double fastest_s = 0;
  double slowest_s = 0;
  bool is_open = false;  ///< a limit ended it
};

/// Points of one line; those with the same name look the same.
struct TimeSeries {
  std::string name;
  std::vector<TimePoint> points;
};

struct TimePanel {
  std::string title;
  std::vector<TimeSeries> series;
};

/// Two panels side by side, of one legend and one axis.
struct TimeRow {
  struct Tick {
    double x;
    std::string above;  ///< two lines of text
    std::string below;
  };
  std::string title;
  std::vector<std::string> names;   ///< in the order of the legend
  std::array<std::string, 2> axis;  ///< what the two lines of each tick are
  std::vector<Tick> ticks;
  std::array<TimePanel, 2> panels;
};

/// Times on a logarithmic axis, marks open where a limit ended them. A standalone SVG 1.1.
/// @param note  stands below
/// @pre  every row has ticks, within which all of its points are
std::string time_chart_svg(const std::string& title, const std::string& note,
                           const std::vector<TimeRow>& rows);

}  // namespace asterism
