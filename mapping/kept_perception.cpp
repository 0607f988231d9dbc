#include "mapping/kept_perception.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <span>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/perception_record.hpp"
#include "io/atomic_file.hpp"
#include "io/grid/grid_file.hpp"
#include "io/json/digest.hpp"
#include "io/json/perception_file.hpp"
#include "io/json/trace_file.hpp"
#include "metric/layout.hpp"

namespace asterism {
namespace {

namespace fs = std::filesystem;

constexpr const char* trace_name = "log.trace.json";
constexpr const char* map_folder_name = "log.lpm";
constexpr const char* record_name = "perception.json";
constexpr const char* told_by = "a trace that was told";

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

/// The rest of what a record and the map folder beside it tell of a log and its trace.
void take_up(const PerceptionRecord& record, const std::string& log, const LogOptions& laser,
             const fs::path& map_folder, const ReadWatch& watch, Perceived& result) {
  read_scans(log, laser, watch, result);
  if (record.scans_digest != digest(result.scans) ||
      record.map_from_robot.size() != result.scans.size())
    throw InputError((map_folder / record_name).string(),
                     "what was perceived of another log, or with other options of the laser",
                     "of the log given");
  result.trace.name = stem_of(log);
  read_place_maps(map_folder, result);
  set_poses(record, result);
  result.remarks = record.remarks;
  result.is_kept = true;
}

/// What a run left, as far as it can be read.
struct Kept {
  PerceptionRecord record;
  Trace trace;
};

std::optional<Kept> find_kept(const fs::path& results) try {
  const fs::path record_file = results / map_folder_name / record_name;
  std::error_code ignored;
  if (!fs::exists(record_file, ignored)) return std::nullopt;
  return Kept{read_perception_file(record_file.string()),
              read_trace_file((results / trace_name).string())};
} catch (const InputError&) {
  return std::nullopt;
}

bool can_be_laid_out(const Displacement& displacement) try {
  lay_out(2, std::vector{PlaceDisplacement{PlaceId(0), PlaceId(1), displacement}});
  return true;
} catch (const std::invalid_argument&) {
  return false;
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
    if (visit.displacement && !can_be_laid_out(*visit.displacement))
      refuse("displacement", "one that no layout can be made of",
             "metres and radians within bounds, with a positive definite covariance");
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
                                          const ReadWatch& watch) {
  const std::optional<Kept> kept = find_kept(results);
  if (!kept) return std::nullopt;
  // What a person did to the trace is not to be lost without a word.
  const std::string trace_file = (results / trace_name).string();
  const bool is_told = kept->record.perceived_by == told_by;
  if (is_told || digest(kept->trace) != kept->record.trace_digest)
    throw InputError(trace_file, is_told ? "a trace that was told" : "a trace that was changed",
                     "--trace with it, copied, or --afresh, which perceives another");
  Perceived result{.trace = kept->trace, .by = name_of(detector)};
  if (kept->record.perceived_by != result.by) return std::nullopt;
  try {
    take_up(kept->record, log, laser, results / map_folder_name, watch, result);
  } catch (const InputError&) {
    return std::nullopt;  // it is perceived again, and a broken log told then
  }
  return result;
}

Perceived perceived_as_told(const ToldTrace& told, const std::string& log, const LogOptions& laser,
                            const ReadWatch& watch) {
  Perceived result{.trace = read_trace_file(told.file), .by = told_by};
  const fs::path record_file = fs::path(told.map_folder) / record_name;
  std::error_code ignored;
  if (!fs::exists(record_file, ignored))
    throw InputError(told.map_folder, std::string("no ") + record_name,
                     "--lpm with the folder log.lpm that a run on this log left");
  const PerceptionRecord record = read_perception_file(record_file.string());
  require_driven(result.trace, record.map_from_robot.size(), told.file);
  take_up(record, log, laser, told.map_folder, watch, result);
  return result;
}

}  // namespace asterism
