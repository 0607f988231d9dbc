#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "perception/place_detector.hpp"

namespace asterism {

/// The visits of a whole drive.
inline std::vector<DetectedVisit> visits_of(PlaceDetector& detector, std::span<const Scan> scans) {
  std::vector<DetectedVisit> visits;
  for (const Scan& scan : scans)
    if (auto visit = detector.observe(scan)) visits.push_back(std::move(*visit));
  while (auto visit = detector.finish()) visits.push_back(std::move(*visit));
  return visits;
}

/// What is complained of, or nothing.
template <class Act>
std::string complaint_of(const Act& act) {
  try {
    act();
  } catch (const PluginError& error) {
    return error.what();
  }
  return "";
}

}  // namespace asterism
