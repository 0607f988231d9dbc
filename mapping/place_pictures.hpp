#pragma once

#include <filesystem>
#include <vector>

#include "io/picture/place_svg.hpp"
#include "perception/scan_detector.hpp"

namespace asterism {

/// The pictures of a run of the detector that ships, collected while it goes on.
class PlacePictures {
 public:
  /// Where the robot is now.
  void follow(const ScanDetector& detector);
  /// A visit was handed over.
  void add(const DetectedVisit& detected, const ScanDetector& detector);
  /// Writes visit-N.svg, visits.svg and way.svg.  @throws Error if it cannot
  void write(const std::filesystem::path& folder, const std::string& log) const;

 private:
  std::vector<PlacePicture> pictures_;
  std::vector<Point2> way_;
  std::vector<NumberedPoint> visits_;
};

}  // namespace asterism
