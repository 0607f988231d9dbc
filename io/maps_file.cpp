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
#include "io/text_file.hpp"

namespace asterism {
namespace {

using Extensions = JsonNode::Extensions;

const char* json_of(bool value) { return value ? "true" : "false"; }
std::string json_of(std::uint64_t value) { return std::to_string(value); }
std::string json_of(double value) { return json_number(value); }
std::string json_of(const std::string& value) { return json_quoted(value); }

template <class Value>
std::string json_of(const std::vector<Value>& values) {
  std::string result = "[";
  for (std::size_t i = 0; i < values.size(); ++i)
    result += (i == 0 ? "" : ", ") + json_of(values[i]);
  return result + ']';
}

std::string json_of(const MapReport::Minimal& minimal) {
  return "{ \"paths\": " + std::to_string(minimal.paths) +
         ", \"places\": " + std::to_string(minimal.places) +
         ", \"count\": " + std::to_string(minimal.count) +
         ", \"certified\": " + json_of(minimal.certified) + " }";
}

template <class Value>
std::string json_of(const std::optional<Value>& value) {
  return value ? json_of(*value) : "null";
}

void write_options(std::ostream& out, const MapOptions& options) {
  out << "{ \"planar\": " << json_of(options.planar) << ", \"check\": " << json_of(options.check)
      << ", \"axioms\": " << json_of(options.axioms)
      << ", \"optional_axioms\": " << json_of(options.optional_axioms)
      << ", \"preference\": " << json_of(options.preference)
      << ", \"certify_s\": " << json_of(options.certify_s)
      << ", \"max_hypotheses\": " << json_of(options.max_hypotheses)
      << ", \"time_limit_s\": " << json_of(options.time_limit_s)
      << ", \"all\": " << json_of(options.all);
  if (!options.assumptions.empty())
    out << ", \"assumptions\": " << json_of(assumption_texts(options.assumptions));
  out << " }";
}

std::vector<std::string> read_names(const JsonNode& node) {
  std::vector<std::string> result;
  for (const JsonNode& item : node.items()) {
    if (std::ranges::find(result, item.string()) != result.end())
      item.refuse(item.found() + " again", "each name once");
    if (item.string().empty()) item.refuse("a name");
    result.push_back(item.string());
  }
  return result;
}

double read_seconds(const JsonNode& node) {
  if (node.number() < 0) node.refuse("seconds, at least 0");
  return node.number();
}

MapOptions read_options(const JsonNode& node) {
  node.require_keys({"planar", "check", "axioms", "optional_axioms", "preference", "certify_s",
                     "max_hypotheses", "time_limit_s", "all", "assumptions"},
                    Extensions::refused);
  MapOptions options;
  options.planar = node["planar"].boolean();
  options.check = node["check"].string();
  if (options.check != "native" && options.check != "solver" && options.check != "both")
    node["check"].refuse("\"native\", \"solver\" or \"both\"");
  options.axioms = node["axioms"].string();
  if (options.axioms.empty()) node["axioms"].refuse("\"shipped\" or a directory");
  options.optional_axioms = read_names(node["optional_axioms"]);
  options.preference = read_names(node["preference"]);
  options.certify_s = read_seconds(node["certify_s"]);
  if (const auto limit = node["max_hypotheses"]; !limit.is_null())
    options.max_hypotheses = limit.count();
  if (const auto limit = node["time_limit_s"]; !limit.is_null())
    options.time_limit_s = read_seconds(limit);
  options.all = node["all"].boolean();
  if (const auto assumed = node["assumptions"]; assumed.exists())
    options.assumptions = read_assumptions(assumed);
  return options;
}

MapReport::Minimal read_minimal(const JsonNode& node) {
  node.require_keys({"paths", "places", "count", "certified"}, Extensions::refused);
  return {node["paths"].count(), node["places"].count(), node["count"].count(),
          node["certified"].boolean()};
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

}  // namespace

void write_maps(std::ostream& out, const MapReport& report, const MapSource& maps) {
  out << "{ \"format\": \"asterism/maps\", \"version\": 1, \"trace\": " << json_of(report.trace)
      << ",\n  \"options\": ";
  write_options(out, report.options);
  out << ",\n  \"consistent\": " << json_of(report.consistent)
      << ",\n  \"per_visit\": " << json_of(report.per_visit)
      << ",\n  \"complete\": " << json_of(report.complete);
  if (report.stopped_by) out << ", \"stopped_by\": " << json_of(*report.stopped_by);
  if (report.explained_visits) out << ",\n  \"explained\": " << json_of(*report.explained_visits);
  out << ",\n  \"minimal\": " << json_of(report.minimal) << ",\n  \"maps\": [";
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
                     "stopped_by", "explained", "minimal", "maps", "ranked"},
                    Extensions::refused);

  MapReport report;
  report.trace = root["trace"].string();
  report.options = read_options(root["options"]);
  if (const auto number = root["consistent"]; !number.is_null()) report.consistent = number.count();
  if (const auto numbers = root["per_visit"]; !numbers.is_null()) {
    report.per_visit.emplace();
    for (const JsonNode& number : numbers.items()) report.per_visit->push_back(number.count());
    if (report.per_visit->empty()) numbers.refuse("an empty array", "a number a visit");
  }
  report.complete = root["complete"].boolean();
  if (const auto reason = root["stopped_by"]; reason.exists() == report.complete)
    reason.refuse(report.complete ? "it only where complete is false" : "a string");
  else if (reason.exists())
    report.stopped_by = reason.string();
  if (const auto minimal = root["minimal"]; !minimal.is_null())
    report.minimal = read_minimal(minimal);
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
