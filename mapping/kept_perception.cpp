#include "mapping/kept_perception.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <span>
#include <utility>

#include "core/error.hpp"
#include "core/perception_record.hpp"
#include "io/atomic_file.hpp"
#include "io/grid/grid_file.hpp"
#include "io/json/digest.hpp"
#include "io/json/perception_file.hpp"
#include "io/json/trace_file.hpp"

namespace asterism {
namespace {

namespace fs = std::filesystem;

constexpr const char* trace_name = "log.trace.json";
constexpr const char* map_folder_name = "log.lpm";
constexpr const char* record_name = "perception.json";

void read_scans(const std::string& log, const LogOptions& laser, const ReadWatch& watch,
                Perceived& result) {
  LogReader reader(log, laser);
  while (std::optional<Scan> scan = reader.next()) {
    result.scans.push_back(*std::move(scan));
    watch(reader, result);
  }
}

/// Takes the maps of the places out of the files that the visits name.
void read_place_maps(const fs::path& folder, Perceived& result) {
  for (Visit& visit : result.trace.visits) {
    result.place_maps.emplace_back();
    if (!visit.lpm) continue;
    result.place_maps.back() = read_grid_file((folder / fs::path(*visit.lpm).filename()).string());
    visit.lpm.reset();
  }
}

void set_poses(const PerceptionRecord& record, Perceived& result) {
  for (std::size_t i = 0; i < result.scans.size(); ++i)
    result.poses.push_back({result.scans[i].stamp_s, record.map_from_robot[i]});
}

void require_same_log(const PerceptionRecord& record, const Perceived& read,
                      const std::string& file) {
  if (record.scans_digest != digest(read.scans) ||
      record.map_from_robot.size() != read.scans.size())
    throw InputError(file, "what was perceived of another log", "of the log given");
}

/// Refuses visits that do not say where in the log they were, and how one leads to the next.
void require_driven(const Trace& trace, std::size_t scans, const std::string& file) {
  long long earliest = 0;
  for (std::size_t k = 0; k < trace.visits.size(); ++k) {
    const Visit& visit = trace.visits[k];
    const auto refuse = [&](const char* key, const std::string& found,
                            const std::string& expected) {
      throw InputError(fmt::format("{}:/visits/{}/{}", file, k, key), found, expected);
    };
    if (k > 0 && !visit.displacement)
      refuse("displacement", "nothing", "that from the visit before");
    if (!visit.scans) refuse("scans", "nothing", "the first and the last scan of the visit");
    const auto [first, last] = *visit.scans;
    if (first < earliest || last < first || last >= static_cast<long long>(scans))
      refuse("scans", fmt::format("{} to {}", first, last),
             fmt::format("scans of the log, which ends with {}, from {} on", scans - 1, earliest));
    earliest = first + 1;
  }
}

}  // namespace

std::string write_place_map(const fs::path& folder, std::size_t visit, const Grid& place_map) {
  const std::string name = fmt::format("visit-{}.json", visit);
  write_grid_file((folder / name).string(), place_map);
  return (folder.filename() / name).string();
}

void keep_perceived(const fs::path& results, const Perceived& perceived) {
  Trace trace = perceived.trace;
  const fs::path map_folder = results / map_folder_name;
  make_folder(map_folder);
  for (std::size_t k = 0; k < trace.visits.size(); ++k) {
    if (const auto& place_map = perceived.place_maps[k])
      trace.visits[k].lpm = write_place_map(map_folder, k, *place_map);
  }
  write_trace_file((results / trace_name).string(), trace);
  PerceptionRecord record{.perceived_by = perceived.by,
                          .trace_digest = digest(trace),
                          .scans_digest = digest(perceived.scans),
                          .remarks = perceived.remarks};
  for (const LocalPose& pose : perceived.poses)
    record.map_from_robot.push_back(pose.map_from_robot);
  write_perception_file((map_folder / record_name).string(), record);
}

std::optional<Perceived> perceived_before(const fs::path& results, const std::string& log,
                                          const LogOptions& laser,
                                          const ScanDetectorOptions& detector,
                                          const ReadWatch& watch) try {
  const fs::path map_folder = results / map_folder_name;
  const std::string record_file = (map_folder / record_name).string();
  if (!fs::exists(record_file)) return std::nullopt;
  const PerceptionRecord record = read_perception_file(record_file);
  Perceived result{.by = name_of(detector)};
  if (record.perceived_by != result.by) return std::nullopt;
  result.trace = read_trace_file((results / trace_name).string());
  if (digest(result.trace) != record.trace_digest) return std::nullopt;
  read_scans(log, laser, watch, result);
  require_same_log(record, result, record_file);
  result.trace.name = stem_of(log);
  read_place_maps(map_folder, result);
  set_poses(record, result);
  result.remarks = record.remarks;
  result.is_kept = true;
  return result;
} catch (const InputError&) {
  return std::nullopt;  // what cannot be taken up is perceived again, and a broken log told then
}

Perceived perceived_as_told(const ToldTrace& told, const std::string& log, const LogOptions& laser,
                            const ReadWatch& watch) {
  const std::string record_file = (fs::path(told.map_folder) / record_name).string();
  const PerceptionRecord record = read_perception_file(record_file);
  Perceived result{.trace = read_trace_file(told.file), .by = "a trace that was told"};
  read_scans(log, laser, watch, result);
  require_same_log(record, result, record_file);
  require_visits(result.trace, told.file, result.scans.size());
  require_driven(result.trace, result.scans.size(), told.file);
  result.trace.name = stem_of(log);
  read_place_maps(told.map_folder, result);
  set_poses(record, result);
  result.remarks = record.remarks;
  result.is_kept = true;
  return result;
}

}  // namespace asterism
