#pragma once

#include <optional>
#include <string_view>

#include "core/grid.hpp"
#include "core/scan.hpp"
#include "core/trace.hpp"

namespace asterism {

/// A visit that has ended, as perception tells it.
struct DetectedVisit {
  Visit visit;                         ///< all but `lpm`, which names a file
  std::optional<Grid> place_map = {};  ///< m_p in the visit's frame, if there is one

  friend bool operator==(const DetectedVisit&, const DetectedVisit&) = default;
};

/// Turns scans into stars: the whole seam between sensing and logic.   [theory §11] [BMK10, §5]
///
/// The visits handed over, in order, make a valid trace: each but the first was entered by an arm,
/// each but the last left by one, and their `scans` do not overlap and do not decrease. All that is
/// asked of them is in perception/detector_laws.hpp. A detector is called by one thread at a time;
/// two detectors may run at once.
class PlaceDetector {
 public:
  PlaceDetector() = default;
  PlaceDetector(const PlaceDetector&) = delete;
  PlaceDetector& operator=(const PlaceDetector&) = delete;
  virtual ~PlaceDetector() = default;

  /// What the detector calls itself, in messages.
  virtual std::string_view name() const noexcept = 0;

  /// The visit just ended, or nothing while travelling or still at a place. Called in the order of
  /// the log.  @throws PluginError if it cannot go on
  virtual std::optional<DetectedVisit> observe(const Scan& scan) = 0;

  /// The log has ended: the next of the visits not yet handed over, the one it ended in last.
  /// Called until it returns nothing.  @throws PluginError
  virtual std::optional<DetectedVisit> finish() = 0;
};

}  // namespace asterism
