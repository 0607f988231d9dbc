#include "io/json/maps_file.hpp"

#include <ostream>
#include <set>
#include <tuple>
#include <type_traits>
#include <utility>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/json/experience_json.hpp"
#include "io/json/json_node.hpp"
#include "io/json/json_writer.hpp"
#include "io/json/map_json.hpp"
#include "io/json/maps_agreement.hpp"
#include "io/json/ranked_json.hpp"
#include "io/json/report_json.hpp"
#include "io/text_file.hpp"

namespace asterism {
namespace {

using Extensions = JsonNode::Extensions;

void write_paths(JsonWriter& json, const SshMap& map) {
  json.list(map.paths, [](JsonWriter& list, const SshMap::Along& along) {
    list.value(std::pair(along.path, sign_of(along.direction)));
  });
}

void write_map(JsonWriter& json, const SshMap& map) {
  json.object([&] {
    json.member("dstates", map.dstates);
    json.line().member("places", map.places);
    write_paths(json.line().key("paths"), map);
    json.line().member("segments", map.segments);
  });
}

std::vector<DStateId> read_dstates(const JsonNode& node, std::size_t views) {
  std::vector<DStateId> result;
  std::size_t known = 0;
  for (const JsonNode& item : node.items(views, "dstates, one a view")) {
    const DStateId dstate(item.count());
    if (dstate.index() > known)
      item.refuse("at most " + std::to_string(known) + ", the next dstate");
    if (dstate.index() == known) ++known;
    result.push_back(dstate);
  }
  return result;
}

SshMap read_map(const JsonNode& node, const Experience& experience) {
  node.require_keys({"dstates", "places", "paths", "segments"}, Extensions::refused);
  SshMap map = make_ssh_map(experience, read_dstates(node["dstates"], experience.views.size()));
  node["places"].require_implied(json_of(map.places));
  node["paths"].require_implied(json_written([&](JsonWriter& json) { write_paths(json, map); }));
  node["segments"].require_implied(json_of(map.segments));
  return map;
}

std::vector<SshMap> read_sorted_maps(const JsonNode& node, const Experience& experience) {
  std::vector<SshMap> maps;
  for (const JsonNode& item : node.items()) {
    maps.push_back(read_map(item, experience));
    if (maps.size() > 1 && maps.back().dstates <= maps[maps.size() - 2].dstates)
      item.refuse("a map not after the one before", "maps sorted by dstates");
  }
  return maps;
}

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

template <class Report>
void write(std::ostream& out, const Report& report, const auto& maps) {
  constexpr bool is_ssh = std::is_same_v<Report, SshReport>;
  JsonWriter json;
  json.object([&] {
    json.member("format", "asterism/maps");
    json.member("version", 1);
    if constexpr (is_ssh) json.member("kind", "ssh");
    json.member("trace", report.trace);
    write_options(json.line().key("options"), report.options);
    if constexpr (is_ssh) write_steps(json.line().key("experience"), report.experience);
    write_counts(json, report, is_ssh ? "per_view" : "per_visit");
    if (report.explained_visits) json.line().member("explained", *report.explained_visits);
    write_minimal(json.line().key("minimal"), report.minimal);
    if (report.bounds)
      write_bounds(json.line().key("bounds"), *report.bounds,
                   report.options.theory.preference.front());
    json.line().key("maps").array([&] {
      maps([&](const auto& map) {
        write_map(json.line(), map);
        out << json.take();
      });
    });
    if constexpr (!is_ssh)
      if (!report.ranked.empty()) json.line().key("ranked").lines(report.ranked, write_ranked_map);
  });
  out << json.take() << '\n';
}

MapReport read_maps(const JsonNode& root) {
  root.require_keys({"format", "version", "trace", "options", "consistent", "per_visit", "complete",
                     "stopped_by", "explained", "minimal", "bounds", "maps", "ranked"},
                    Extensions::refused);
  MapReport report{read_findings(root, "per_visit", "a visit")};
  if (const auto bounds = root["bounds"]; bounds.exists()) {
    if (report.options.theory.preference.empty())
      bounds.refuse("it only where something is preferred");
    report.bounds = read_bounds(bounds, report.options.theory.preference.front());
  }
  report.maps = read_sorted_maps(root["maps"]);
  if (const auto explained = root["explained"]; explained.exists())
    report.explained_visits = explained.count();
  if (const auto ranked = root["ranked"]; ranked.exists()) report.ranked = read_ranked(ranked);
  require_agreement(root, report);
  return report;
}

SshReport read_ssh_maps(const JsonNode& root) {
  root.require_keys({"format", "version", "kind", "trace", "options", "experience", "consistent",
                     "per_view", "complete", "stopped_by", "minimal", "maps"},
                    Extensions::refused);
  auto [views, actions] = read_steps(root["experience"]);
  SshReport report{read_findings(root, "per_view", "a view"),
                   {root["trace"].string(), std::move(views), std::move(actions)}};
  report.maps = read_sorted_maps(root["maps"], report.experience);
  require_agreement(root, report);
  return report;
}

}  // namespace

void write_maps(std::ostream& out, const MapReport& report, const MapSource& maps) {
  write(out, report, maps);
}

void write_maps(std::ostream& out, const SshReport& report, const SshMapSource& maps) {
  write(out, report, maps);
}

void write_maps_file(const std::string& file, const MapReport& report) {
  write_atomically(file, [&](std::ostream& out) { write_maps(out, report); });
}

AnyReport read_any_maps(std::string_view json_text, const std::string& file_name) {
  if (json_text.size() > max_maps_bytes)
    throw InputError(file_name, std::to_string(json_text.size()) + " bytes",
                     "at most " + std::to_string(max_maps_bytes));
  const JsonDocument document{file_name, parse_json(json_text, file_name)};
  const JsonNode root(document);
  root["format"].require("\"asterism/maps\"");
  root["version"].require("1");
  const JsonNode kind = root["kind"];
  if (!kind.exists()) return read_maps(root);
  kind.require("\"ssh\"");
  return read_ssh_maps(root);
}

AnyReport read_any_maps_file(const std::string& file) {
  return read_any_maps(read_text_file(file, max_maps_bytes), file);
}

}  // namespace asterism
