#include "benchmarks/perception.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <memory>
#include <numeric>
#include <span>

#include "benchmarks/heap.hpp"
#include "benchmarks/measure.hpp"
#include "perception/scan_detector.hpp"
#include "simulation/drive.hpp"
#include "simulation/ring_building.hpp"

namespace asterism {
namespace {

constexpr std::size_t scans_a_grid = 10;  // scans from one grid to the next that is looked at alone

/// Processor time of this program, to a microsecond.
double processor_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double mean(std::span<const double> times_s) {
  return std::reduce(times_s.begin(), times_s.end()) / static_cast<double>(times_s.size());
}

double most_of_99_in_100(std::vector<double> times_s) {
  std::ranges::sort(times_s);
  return times_s[times_s.size() * 99 / 100];
}

/// What a drive took, in processor time but for `wall_s`.
struct Perceived {
  std::vector<double> scan_s;
  std::vector<double> grid_s;  ///< from a ready grid to its gateways and star
  double wall_s = 0;           ///< of all scans
  std::size_t visits = 0;
  std::size_t heap_bytes = 0;  ///< the most there were
};

Perceived perceive(const ScanSource& scans, std::size_t most_scans) {
  Perceived result;
  const std::size_t heap_before = heap_bytes();
  reset_heap_peak();
  ScanDetector detector;
  while (result.scan_s.size() < most_scans) {
    const std::optional<Scan> scan = scans();
    if (!scan) break;
    const Stopwatch stopwatch;
    const double begin_s = processor_s();
    result.visits += detector.observe(*scan).has_value();
    result.scan_s.push_back(processor_s() - begin_s);
    result.wall_s += stopwatch.seconds();
    if (result.scan_s.size() % scans_a_grid != 0) continue;
    const double ready_s = processor_s();
    local_topology(detector.map().grid(), detector.map_from_robot().position());
    result.grid_s.push_back(processor_s() - ready_s);
  }
  while (detector.finish()) ++result.visits;
  result.heap_bytes = heap_peak_bytes() - heap_before;
  return result;
}

ScanSource simulated_drive() {
  RandomEngine engine(1);
  const Building building = ring_building(engine);
  const auto drive =
      std::make_shared<Drive>(building, ring_route(building.world), DriveOptions{}, engine());
  return [drive] { return drive->next(); };
}

}  // namespace

std::vector<PerceptionCase> perception_cases(const std::string& data_folder) {
  std::vector<PerceptionCase> cases{{"aces", {}}, {"simulated ring", simulated_drive()}};
  const std::filesystem::path log = std::filesystem::path(data_folder) / "aces/aces.log.xz";
  if (std::filesystem::exists(log)) {
    const auto reader = std::make_shared<LogReader>(log.string());
    cases.front().scans = [reader] { return reader->next(); };
  }
  return cases;
}

void add_perception_table(Report& report, std::vector<PerceptionCase> cases,
                          std::size_t most_scans) {
  report.begin_table(
      "Perception, gateways at every scan, in processor time; and gateways from a ready grid:",
      {"drive", "scans", "visits", "a scan, by the wall's clock", "a scan", "99 %", "longest",
       "first tenth", "last tenth", "from a grid", "99 %", "peak of the heap"});
  for (const auto& [name, scans] : cases) {
    if (!scans) {
      report.add_row({name, "", "", "", "", "", "", "", "", "", "", ""});
      continue;
    }
    const Perceived drive = perceive(scans, most_scans);
    const std::size_t tenth = std::max<std::size_t>(1, drive.scan_s.size() / 10);
    const std::span<const double> times_s = drive.scan_s;
    report.add_row({name, count_text(times_s.size()), count_text(drive.visits),
                    duration_text(drive.wall_s / static_cast<double>(times_s.size())),
                    duration_text(mean(times_s)), duration_text(most_of_99_in_100(drive.scan_s)),
                    duration_text(std::ranges::max(times_s)),
                    duration_text(mean(times_s.first(tenth))),
                    duration_text(mean(times_s.last(tenth))), duration_text(mean(drive.grid_s)),
                    duration_text(most_of_99_in_100(drive.grid_s)),
                    fmt::format("{:.1f} MB", static_cast<double>(drive.heap_bytes) / 1e6)});
  }
}

}  // namespace asterism
