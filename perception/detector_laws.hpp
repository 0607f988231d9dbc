#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "perception/place_detector.hpp"

namespace asterism {

/// What every detector keeps to, checked visit by visit as they are handed over:
///
/// - arms: each visit but the first was entered by an arm with a gateway, each but the last left by
///   one, so that the visits make a valid trace
/// - scans: where given, first and last of a visit were fed before it was handed over, and visits
///   follow one another; there are no more visits than scans
/// - stamps: where given with scans, those of the two scans, the smaller first
/// - gateways: each measures an arm with α = 1, no arm twice; finite, of positive width; seen from
///   their middle or from the visit's origin they stand clockwise as their arms do
/// - displacement: from the second visit on always or never; finite; with a covariance
/// - place map: as large as it says, log-odds that are numbers, the visit's origin inside; not
///   beside a map in a file
///
/// Remembers the scans and visits so far: one drive each, one thread at a time.
class DetectorLaws {
 public:
  /// A scan has been given to the detector.
  void fed(const Scan& scan);

  /// The laws that the next visit breaks, "visit 3/gateways: found ...; expected ...".
  std::vector<std::string> broken_by(const DetectedVisit& next);

 private:
  struct Stamp {
    long long scan;
    double stamp_s;
  };
  const Stamp* find_stamp(long long scan) const;

  void check_arms(const Visit& visit);
  void check_scans(const Visit& visit);
  void check_gateways(const Visit& visit);
  void check_displacement(const Visit& visit);
  void check_place_map(const DetectedVisit& detected);
  void complain(const std::string& what, const std::string& found, const std::string& expected);

  std::deque<Stamp> stamps_;  ///< of the scans that the next visit may have
  std::size_t scans_ = 0;
  std::size_t visits_ = 0;
  bool was_left_ = true;  ///< the previous visit, by an arm
  std::optional<long long> last_scan_;
  std::optional<bool> has_displacements_;
  std::vector<std::string> broken_;
};

/// Makes a detector that has seen nothing yet.
using DetectorFactory = std::function<std::unique_ptr<PlaceDetector>()>;

/// Puts new detectors through runs of these scans and returns the laws they broke: those of
/// DetectorLaws, and that
///
/// - determinism: two runs on the same scans give the same visits
/// - prefix: on a drive that stops early the visits handed over before it stopped are the first of
///   those of the whole drive, and the other way round: no visit depends on scans that came after
///
/// @param scans  of one drive, in the order of the log
/// @return  one line a law broken, "visit 3/gateways: found ...; expected ..."
///
/// When a visit is handed over is left free, since programs answer when they like. A PluginError
/// counts as a law broken.
std::vector<std::string> broken_laws(const DetectorFactory& make, std::span<const Scan> scans);

}  // namespace asterism
