#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/grid.hpp"
#include "core/pose_covariance.hpp"

namespace asterism {

/// An upright rectangle of the plane that grows with what it is to show.
class PlanBounds {
 public:
  void include(Point2 point, double margin_m = 0);
  /// What a grid knows, a few stray cells at the edge aside.
  void include(const Grid& grid);

  bool is_empty() const { return is_empty_; }
  Point2 low() const { return low_; }
  Point2 high() const { return high_; }

 private:
  bool is_empty_ = true;
  Point2 low_;
  Point2 high_;
};

/// A floor plan under construction: one frame, +x to the right, +y up; things added later lie on
/// top. Ends as an inline SVG without ids, so that any number of them share a page.
class PlanPicture {
 public:
  /// @pre  shown is not empty
  PlanPicture(const PlanBounds& shown, double max_width_px, double max_height_px);

  /// Free space white, walls dark, the unknown grey.
  /// @param opacity  below 1 what lies under it is seen through it
  void add_grid(const Grid& grid, const Pose2& page_from_frame = {}, double opacity = 1);
  /// A line through points, thinned to what can be told apart.
  /// @param style  attributes, escaped
  void add_line(std::span<const Point2> points, const std::string& style);

  struct Gateway {
    Point2 middle = {};
    double outward_rad = 0;
    double width_m = 0;
    std::string colour = {};
    bool is_open = false;  ///< no segment yet: drawn with a dashed way on
  };
  void add_gateway(const Gateway& gateway);
  // Labels keep off discs and each other; where there is no room for one, it is left out.

  /// In front of a gateway, in its colour; beside it where that is taken.
  void add_label_ahead(const Gateway& gateway, const std::string& label);
  /// At one end of a gateway, where no way leads on; elsewhere near it where both are taken.
  void add_label_beside(const Gateway& gateway, const std::string& label);

  /// Where a pose is with a probability of 95 %, its heading aside.
  void add_ellipse(const Pose2& page_from_place, const PoseCovariance& covariance);

  /// A numbered disc, with the directions in which its local-paths leave.
  struct Direction {
    double heading_rad = 0;
    std::string colour = {};
  };
  void add_place(Point2 at, std::size_t number, const std::vector<Direction>& directions);
  /// Out of a place's disc, a bar where no way leads on.
  void add_dead_end(Point2 place, const Direction& direction);

  /// A dot: where the robot began.
  void add_start(Point2 at);
  /// A word above or beside a spot.
  void add_label_at(Point2 at, const std::string& label);
  /// An arrowhead.
  void add_robot(const Pose2& page_from_robot);

  /// A length in round metres, below the picture.
  void add_scale_bar();

  /// @param title  what it shows, for those who cannot see it
  std::string svg(const std::string& title) const;

 private:
  /// Upright, in pixels.
  struct Box {
    Point2 low = {};
    Point2 high = {};
  };
  /// A gateway in pixels: its middle, and the unit vectors outwards and to the left of that.
  struct Seen {
    Point2 middle = {};
    Point2 out = {};
    Point2 left = {};
  };

  Point2 pixel(Point2 in_page) const;
  Seen seen(const Gateway& gateway) const;
  void take(Point2 at_px, double reach_px);
  double taken_px2(const Box& box) const;
  void add_label(const std::vector<Point2>& spots_px, const std::string& colour,
                 const std::string& label);

  Point2 low_;
  double px_per_m_ = 1;
  double width_px_ = 0;
  double plan_height_px_ = 0;  ///< without what stands below
  double height_px_ = 0;
  std::string body_;
  std::vector<Box> taken_;  ///< what labels keep off, where they can
};

}  // namespace asterism
