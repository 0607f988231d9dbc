#include "mapping/perceived.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <numbers>
#include <span>
#include <utility>

#include "core/error.hpp"
#include "io/grid/grid_file.hpp"

namespace asterism {
namespace {

/// What tells of no time passing, or of time running backwards: it is gone by the order of scans.
std::vector<std::string> remarks_on_stamps(std::span<const Scan> scans) {
  std::vector<long long> backwards, equal;
  for (std::size_t i = 1; i < scans.size(); ++i) {
    if (scans[i].stamp_s < scans[i - 1].stamp_s) backwards.push_back(scans[i].number);
    if (scans[i].stamp_s == scans[i - 1].stamp_s) equal.push_back(scans[i].number);
  }
  std::vector<std::string> remarks;
  const auto remark = [&](const char* what, const std::vector<long long>& at) {
    if (at.empty()) return;
    remarks.push_back(
        fmt::format("{} at {} of {} scans, first at scan {}: the order of the log counts", what,
                    at.size(), scans.size(), at.front()));
  };
  remark("stamps run backwards", backwards);
  remark("stamps repeat", equal);
  return remarks;
}

/// The first few, each, and how many more.
std::vector<std::string> remarks_on_jumps(std::span<const ScanDetector::Jump> jumps) {
  constexpr std::size_t most = 5;
  std::vector<std::string> remarks;
  for (const auto& [scan, motion] : jumps.first(std::min(most, jumps.size())))
    remarks.push_back(fmt::format(
        "odometry jumps {:.1f} m and {:.0f} degrees at scan {}: bridged by scan matching",
        norm(motion.position()), std::abs(motion.heading_rad) * 180 / std::numbers::pi, scan));
  if (jumps.size() > most)
    remarks.push_back(fmt::format("odometry jumps {} times more", jumps.size() - most));
  return remarks;
}

}  // namespace

Perceived perceive(const std::string& file, const LogOptions& laser,
                   const ScanDetectorOptions& options, const ReadWatch& watch) {
  Perceived result{.by = name_of(options)};
  result.trace.name = stem_of(file);
  LogReader log(file, laser);
  ScanDetector detector(options);
  const std::size_t scans = detect(
      log, detector,
      [&](const Scan& scan) {
        result.scans.push_back(scan);
        result.poses.push_back({scan.stamp_s, detector.map_from_robot()});
        watch(log, result);
      },
      [&](DetectedVisit detected) {
        if (detected.place_map) detected.place_map = as_written(*std::move(detected.place_map));
        result.place_maps.push_back(std::move(detected.place_map));
        result.trace.visits.push_back(std::move(detected.visit));
      });
  require_visits(result.trace, file, scans);
  result.remarks = remarks_on_stamps(result.scans);
  std::ranges::copy(remarks_on_jumps(detector.jumps()), std::back_inserter(result.remarks));
  return result;
}

std::string name_of(const ScanDetectorOptions& options) {
  return fmt::format("asterism {}, gateways of {} m and more", ASTERISM_VERSION,
                     options.topology.skeleton.min_gateway_width_m);
}

std::size_t detect(LogReader& log, PlaceDetector& detector,
                   const std::function<void(const Scan&)>& seen,
                   const std::function<void(DetectedVisit)>& visited) {
  std::size_t scans = 0;
  while (const std::optional<Scan> scan = log.next()) {
    if (auto visit = detector.observe(*scan)) visited(std::move(*visit));
    seen(*scan);
    ++scans;
  }
  while (auto visit = detector.finish()) visited(std::move(*visit));
  return scans;
}

void require_visits(const Trace& trace, const std::string& log, std::size_t scans) {
  if (trace.visits.empty())
    throw InputError(log, fmt::format("no place in {} scans", scans), "a drive that visits one");
  require_valid(trace);
}

std::string stem_of(const std::string& file) {
  const std::string name = std::filesystem::path(file).filename().string();
  const std::string stem = name.substr(0, name.find('.', 1));
  return stem.empty() ? "log" : stem;
}

}  // namespace asterism
