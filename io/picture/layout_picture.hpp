#pragma once

#include <string>

#include "core/run_report.hpp"

namespace asterism {

/// How large a picture may be.
struct PictureSize {
  double max_width_px = 0;
  double max_height_px = 0;
};

/// A model's global map with its layout on it: places, segments, gateways, the robot's way, and 95
/// % ellipses of the places.
/// @param has_labels  whether gateways are named
std::string layout_svg(const RunReport::Model& model, const Trace& trace, PictureSize size,
                       bool has_labels, const std::string& title);

/// Two places that lie on one spot: their place maps laid over each other where the layout has
/// them, with the gateways of the one in orange, of the other in blue.
std::string shared_spot_svg(const RunReport& report, const RankedMap& ranked,
                            const SharedSpot& spot, const std::string& title);

/// A grid alone.
std::string grid_svg(const Grid& grid, PictureSize size, const std::string& title);

/// Place maps, each as seen on one visit with its gateways, all to one scale.
class PlaceMaps {
 public:
  /// Coloured and turned as in the report's best model, if there is one.
  explicit PlaceMaps(const RunReport& report);
  /// Empty if neither map nor gateways of that visit are known.
  std::string svg(VisitId visit) const;

 private:
  Point2 middle_of(std::size_t visit) const;
  Pose2 page_from_visit(std::size_t visit) const;

  const RunReport& report_;
  double half_side_m_ = 0;
};

}  // namespace asterism
