#include <algorithm>

#include "core/error.hpp"
#include "perception/detector_laws.hpp"

namespace asterism {
namespace {

/// What a new detector made of some scans.
struct Run {
  std::vector<DetectedVisit> visits = {};
  std::vector<std::size_t> handed_over = {};  ///< how many scans it had been given, visit by visit
  std::vector<std::string> broken = {};
};

Run run(const DetectorFactory& make, std::span<const Scan> scans) {
  Run result;
  DetectorLaws laws;
  std::size_t given = 0;
  const auto take = [&](std::optional<DetectedVisit> seen) {
    if (!seen) return false;
    const auto broken = laws.broken_by(*seen);
    result.broken.insert(result.broken.end(), broken.begin(), broken.end());
    result.visits.push_back(std::move(*seen));
    result.handed_over.push_back(given);
    return result.visits.size() <= scans.size();  // or it might never end
  };
  try {
    const auto detector = make();
    for (const Scan& scan : scans) {
      laws.fed(scan);
      ++given;
      take(detector->observe(scan));
    }
    ++given;  // the end itself, so that what finish returns was not handed over before it
    while (take(detector->finish())) {
    }
  } catch (const PluginError& error) {
    result.broken.push_back(error.what());
  }
  return result;
}

/// The visits that `told` handed over by the time `scans` were given are the first of `others`.
bool starts_with(const Run& others, const Run& told, std::size_t scans) {
  for (std::size_t k = 0; k < told.visits.size() && told.handed_over[k] <= scans; ++k)
    if (k >= others.visits.size() || others.visits[k] != told.visits[k]) return false;
  return true;
}

}  // namespace

std::vector<std::string> broken_laws(const DetectorFactory& make, std::span<const Scan> scans) {
  const Run whole = run(make, scans);
  std::vector<std::string> broken = whole.broken;
  if (run(make, scans).visits != whole.visits)
    broken.push_back("determinism: found other visits in a second run; expected the same");
  for (std::size_t quarter = 1; quarter < 4; ++quarter) {
    const std::size_t length = scans.size() * quarter / 4;
    const Run part = run(make, scans.first(length));
    const std::string where = "prefix: the first " + std::to_string(length) + " scans: ";
    for (const std::string& law : part.broken) broken.push_back(where + law);
    if (!starts_with(part, whole, length) || !starts_with(whole, part, length))
      broken.push_back(where + "found other visits; expected those of the whole drive");
  }
  return broken;
}

}  // namespace asterism
