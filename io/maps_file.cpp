#include "io/maps_file.hpp"

#include <algorithm>
#include <ostream>
#include <tuple>
#include <utility>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/json_node.hpp"
#include "io/map_json.hpp"
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
      << ", \"all\": " << json_of(options.all) << " }";
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
                     "max_hypotheses", "time_limit_s", "all"},
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

std::string number_of_maps(std::uint64_t number) {
  return std::to_string(number) + (number == 1 ? " map" : " maps");
}

/// Where nothing cut the run short, all counts are those of the same maps.
void require_complete(const JsonNode& root, const MapReport& report) {
  if (report.consistent && report.per_visit && *report.consistent != report.per_visit->back())
    root["consistent"].refuse(std::to_string(report.per_visit->back()) + ", the last of per_visit");
  if (report.consistent && (*report.consistent > 0) != report.minimal.has_value())
    root["minimal"].refuse(report.minimal ? "null, since no map is consistent"
                                          : "an object, since a map is consistent");
  if (report.per_visit && !report.maps.empty() &&
      report.per_visit->size() != report.maps.front().visits.size())
    root["per_visit"].refuse(
        "an array of " + std::to_string(report.per_visit->size()),
        std::to_string(report.maps.front().visits.size()) + ", one a visit of the maps");
  if (report.options.all && report.consistent && *report.consistent != report.maps.size())
    root["maps"].refuse(number_of_maps(report.maps.size()), std::to_string(*report.consistent));
}

/// What is to be minimised, most important first. Nothing where the maps do not tell it: where a
/// predicate is another than these, or a user's axioms may make fewer paths of a map.
std::optional<std::vector<std::size_t>> extents(const MapOptions& options, std::size_t paths,
                                                std::size_t places) {
  std::vector<std::size_t> result;
  for (const std::string& predicate : options.preference) {
    if (options.axioms != "shipped" || (predicate != "path" && predicate != "place"))
      return std::nullopt;
    result.push_back(predicate == "path" ? paths : places);
  }
  return result;
}

/// The maps listed hold as many minimal models as told, and none below them; or only these.
void require_minimal(const JsonNode& root, const MapReport& report) {
  const auto& [paths, places, count, certified] = *report.minimal;
  if (count == 0) root["minimal"]["count"].refuse("at least 1");
  if (report.maps.size() < count || (!report.options.all && report.maps.size() != count))
    root["maps"].refuse(number_of_maps(report.maps.size()),
                        (report.options.all ? "at least " : "") + std::to_string(count));

  const auto least = extents(report.options, paths, places);
  if (!least) return;
  std::size_t number = 0;
  for (std::size_t i = 0; i < report.maps.size(); ++i) {
    const TopologicalMap& map = report.maps[i];
    const auto these = extents(report.options, map.paths.size(), map.places.size());
    if (these == least) ++number;
    if (these < least || (!report.options.all && these != least))
      root["maps"].items()[i].refuse(
          std::to_string(map.paths.size()) + " paths, " + std::to_string(map.places.size()) +
              " places",
          std::to_string(paths) + " and " + std::to_string(places) + " as in minimal");
  }
  if (number != count)
    root["maps"].refuse(number_of_maps(number) + " as in minimal", std::to_string(count));
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
  out << ",\n  \"minimal\": " << json_of(report.minimal) << ",\n  \"maps\": [";
  bool is_first = true;
  maps([&](const TopologicalMap& map) {
    out << (std::exchange(is_first, false) ? "\n" : ",\n");
    write_map(out, map);
  });
  out << (is_first ? "] }\n" : " ] }\n");
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
                     "stopped_by", "minimal", "maps"},
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

  if (report.complete) require_complete(root, report);
  if (report.minimal)
    require_minimal(root, report);
  else if (!report.options.all && !report.maps.empty())
    root["maps"].refuse(number_of_maps(report.maps.size()), "none, as minimal is null");
  return report;
}

MapReport read_maps_file(const std::string& file) {
  return read_maps(read_text_file(file, max_maps_bytes), file);
}

}  // namespace asterism
