#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>

#include "axioms/axiom_set.hpp"
#include "cli/map_text.hpp"
#include "cli/options.hpp"
#include "core/error.hpp"
#include "io/carmen_log.hpp"
#include "io/maps_file.hpp"
#include "io/trace_file.hpp"

namespace asterism {
namespace {

bool is_log(const std::string& file) {
  return std::ranges::any_of(std::array{".log", ".clf"}, [&](const std::string& kind) {
    return file.ends_with(kind) || file.ends_with(kind + ".gz") || file.ends_with(kind + ".xz");
  });
}

/// Reads a log whole; tells what a drive it is.
std::string log_text(const std::string& file) {
  LogReader reader(file);
  std::optional<Scan> scan = reader.next();
  const std::size_t beams = scan->ranges_m.size();  // a log without a scan is refused
  double first_s = scan->stamp_s, last_s = scan->stamp_s, length_m = 0;
  long long scans = 0;
  for (Point2 before = scan->odom_from_robot.position(); scan; scan = reader.next()) {
    const Point2 at = scan->odom_from_robot.position();
    length_m += norm(at - before);
    before = at;
    first_s = std::min(first_s, scan->stamp_s);
    last_s = std::max(last_s, scan->stamp_s);
    ++scans;
  }
  return fmt::format("log: {} scans of {} beams, {:.1f} s, {:.1f} m", scans, beams,
                     last_s - first_s, length_m);
}

/// Reads a file of whatever kind its name says; tells what it is.
std::string validated(const std::string& file) {
  if (file.ends_with("maps.json")) {
    const MapReport report = read_maps_file(file);
    return fmt::format("maps of {}: {} listed", printable(report.trace), report.maps.size());
  }
  if (is_log(file)) return log_text(file);
  if (std::filesystem::is_directory(file)) {
    const AxiomSet axioms = AxiomSet::read(file);
    return fmt::format("a folder of {} axioms", axioms.axioms().size());
  }
  const Trace trace = read_trace_file(file);
  return fmt::format("trace {}: {} visits", printable(trace.name), trace.visits.size());
}

}  // namespace

int validate_command(const std::vector<std::string>& files) {
  int result = exit_consistent;
  for (const std::string& file : files) {
    try {
      fmt::print("{}: valid, {}\n", file, validated(file));
    } catch (const InputError& error) {
      fmt::print(stderr, "{}\n", error.what());
      result = exit_bad_input;
    }
  }
  return result;
}

}  // namespace asterism
