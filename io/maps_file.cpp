#include "io/maps_file.hpp"

#include <algorithm>
#include <ostream>
#include <set>
#include <tuple>
#include <utility>

#include "core/error.hpp"
#include "io/assumption_json.hpp"
#include "io/atomic_file.hpp"
#include "io/json_node.hpp"
#include "io/map_json.hpp"
#include "io/maps_agreement.hpp"
#include "io/ranked_json.hpp"
#include "io/report_json.hpp"
#include "io/text_file.hpp"

namespace asterism {
namespace {

std::vector<TopologicalMap> read_sorted_maps(const JsonNode& node) {
  std::vector<TopologicalMap> maps;
  for (const JsonNode& item : node.items()) {
    maps.push_back(read_map(item));
    if (maps.size() == 1) continue;
    const auto& before = maps[maps.size() - 2];
    const auto& map = maps.back();
    if (map.visits.size() != before.visits.size())
      item["visits"].refuse("an array of " + std::to_string(map.visits.size()),
                            std::to_string(before.visits.size()) + " as in the map before");
    if (std::tie(map.visits, map.entered) <= std::tie(before.visits, before.entered))
      item.refuse("a map not after the one before", "maps sorted by visits, then entered");
  }
  return maps;
}

std::vector<RankedMap> read_ranked(const JsonNode& node) {
  std::vector<RankedMap> result;
  std::set<std::tuple<std::vector<PlaceId>, std::vector<std::optional<std::size_t>>>> known;
  for (const JsonNode& item : node.items()) {
    result.push_back(read_ranked_map(item));
    const TopologicalMap& map = result.back().map;
    if (!known.emplace(map.visits, map.entered).second) item.refuse("a map again", "each map once");
    if (result.size() > 1 && result.back().is_plausible && !result[result.size() - 2].is_plausible)
      item["plausible"].refuse("false, as in the map before");
  }
  if (result.empty()) node.refuse("an empty array", "at least one map, or no such key");
  return result;
}

}  // namespace

void write_maps(std::ostream& out, const MapReport& report, const MapSource& maps) {
  out << "{ \"format\": \"asterism/maps\", \"version\": 1, \"trace\": " << json_quoted(report.trace)
      << ",\n  \"options\": " << options_json(report.options) << ",\n  "
      << counts_json({report.consistent, report.per_visit, report.complete, report.stopped_by},
                     "per_visit");
  if (report.explained_visits)
    out << ",\n  \"explained\": " << std::to_string(*report.explained_visits);
  out << ",\n  \"minimal\": " << minimal_json(report.minimal);
  if (report.bounds)
    out << ",\n  \"bounds\": " << bounds_json(*report.bounds, report.options.preference.front());
  out << ",\n  \"maps\": [";
  bool is_first = true;
  maps([&](const TopologicalMap& map) {
    out << (std::exchange(is_first, false) ? "\n" : ",\n");
    write_map(out, map);
  });
  out << (is_first ? "]" : " ]");
  for (const RankedMap& ranked : report.ranked) {
    out << (&ranked == report.ranked.data() ? ",\n  \"ranked\": [\n" : ",\n");
    write_ranked_map(out, ranked);
  }
  out << (report.ranked.empty() ? " }\n" : " ] }\n");
}

void write_maps(std::ostream& out, const MapReport& report) {
  write_maps(out, report, [&](const auto& write) {
    for (const TopologicalMap& map : report.maps) write(map);
  });
}

void write_maps_file(const std::string& file, const MapReport& report) {
  write_atomically(file, [&](std::ostream& out) { write_maps(out, report); });
}

MapReport read_maps(std::string_view json_text, const std::string& file_name) {
  if (json_text.size() > max_maps_bytes)
    throw InputError(file_name, std::to_string(json_text.size()) + " bytes",
                     "at most " + std::to_string(max_maps_bytes));
  const JsonDocument document{file_name, parse_json(json_text, file_name)};
  const JsonNode root(document);
  root["format"].require("\"asterism/maps\"");
  root["version"].require("1");
  root.require_keys({"format", "version", "trace", "options", "consistent", "per_visit", "complete",
                     "stopped_by", "explained", "minimal", "bounds", "maps", "ranked"},
                    JsonNode::Extensions::refused);

  MapReport report;
  report.trace = root["trace"].string();
  report.options = read_options(root["options"]);
  auto [consistent, per_visit, complete, stopped_by] = read_counts(root, "per_visit", "a visit");
  report.consistent = consistent;
  report.per_visit = std::move(per_visit);
  report.complete = complete;
  report.stopped_by = std::move(stopped_by);
  report.minimal = read_minimal(root["minimal"]);
  if (const auto bounds = root["bounds"]; bounds.exists()) {
    if (report.options.preference.empty()) bounds.refuse("it only where something is preferred");
    report.bounds = read_bounds(bounds, report.options.preference.front());
  }
  report.maps = read_sorted_maps(root["maps"]);
  if (const auto explained = root["explained"]; explained.exists())
    report.explained_visits = explained.count();
  if (const auto ranked = root["ranked"]; ranked.exists()) report.ranked = read_ranked(ranked);

  require_agreement(root, report);
  return report;
}

MapReport read_maps_file(const std::string& file) {
  return read_maps(read_text_file(file, max_maps_bytes), file);
}

}  // namespace asterism
