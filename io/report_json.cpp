#include "io/report_json.hpp"

#include <algorithm>

#include "io/assumption_json.hpp"

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

template <class Value>
std::string json_of(const std::optional<Value>& value) {
  return value ? json_of(*value) : "null";
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

}  // namespace

std::string options_json(const MapOptions& options) {
  return std::string("{ \"planar\": ") + json_of(options.planar) +
         ", \"check\": " + json_of(options.check) + ", \"axioms\": " + json_of(options.axioms) +
         ", \"optional_axioms\": " + json_of(options.optional_axioms) +
         ", \"preference\": " + json_of(options.preference) +
         ", \"certify_s\": " + json_of(options.certify_s) +
         ", \"max_hypotheses\": " + json_of(options.max_hypotheses) +
         ", \"time_limit_s\": " + json_of(options.time_limit_s) +
         ", \"all\": " + json_of(options.all) +
         (options.memory_limit_bytes
              ? ", \"memory_limit_bytes\": " + json_of(*options.memory_limit_bytes)
              : "") +
         (options.method ? ", \"method\": " + json_of(*options.method) : "") +
         (options.assumptions.empty()
              ? ""
              : ", \"assumptions\": " + json_of(assumption_texts(options.assumptions))) +
         " }";
}

MapOptions read_options(const JsonNode& node) {
  node.require_keys(
      {"planar", "check", "axioms", "optional_axioms", "preference", "certify_s", "max_hypotheses",
       "time_limit_s", "all", "memory_limit_bytes", "method", "assumptions"},
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
  if (const auto limit = node["memory_limit_bytes"]; limit.exists())
    options.memory_limit_bytes = limit.count();
  if (const auto method = node["method"]; method.exists()) {
    options.method = method.string();
    if (options.method != "search" && options.method != "listing")
      method.refuse("\"search\" or \"listing\"");
  }
  if (const auto assumed = node["assumptions"]; assumed.exists())
    options.assumptions = read_assumptions(assumed);
  return options;
}

std::string counts_json(const MapCounts& counts, const std::string& key) {
  std::string text = "\"consistent\": " + json_of(counts.consistent) + ",\n  \"" + key +
                     "\": " + json_of(counts.per_step) +
                     ",\n  \"complete\": " + json_of(counts.complete);
  if (counts.stopped_by) text += ", \"stopped_by\": " + json_of(*counts.stopped_by);
  return text;
}

MapCounts read_counts(const JsonNode& root, std::string_view key, const std::string& step) {
  MapCounts counts;
  if (const auto number = root["consistent"]; !number.is_null()) counts.consistent = number.count();
  if (const auto numbers = root[key]; !numbers.is_null()) {
    counts.per_step.emplace();
    for (const JsonNode& number : numbers.items()) counts.per_step->push_back(number.count());
    if (counts.per_step->empty()) numbers.refuse("an empty array", "a number " + step);
  }
  counts.complete = root["complete"].boolean();
  if (const auto reason = root["stopped_by"]; reason.exists() == counts.complete)
    reason.refuse(counts.complete ? "it only where complete is false" : "a string");
  else if (reason.exists())
    counts.stopped_by = reason.string();
  return counts;
}

std::string minimal_json(const std::optional<MapReport::Minimal>& minimal) {
  if (!minimal) return "null";
  return "{ \"paths\": " + std::to_string(minimal->paths) +
         ", \"places\": " + std::to_string(minimal->places) +
         ", \"count\": " + std::to_string(minimal->count) +
         ", \"certified\": " + json_of(minimal->certified) + " }";
}

std::optional<MapReport::Minimal> read_minimal(const JsonNode& node) {
  if (node.is_null()) return std::nullopt;
  node.require_keys({"paths", "places", "count", "certified"}, Extensions::refused);
  return MapReport::Minimal{node["paths"].count(), node["places"].count(), node["count"].count(),
                            node["certified"].boolean()};
}

std::string bounds_json(const MapReport::Bounds& bounds, const std::string& first_extent) {
  std::string text =
      "{ \"" + first_extent + "s_at_least\": " + std::to_string(bounds.at_least) + ", \"best\": ";
  if (!bounds.best) return text + "null }";
  return text + "{ \"paths\": " + std::to_string(bounds.best->paths) +
         ", \"places\": " + std::to_string(bounds.best->places) +
         ", \"count\": " + std::to_string(bounds.best->count) + " } }";
}

MapReport::Bounds read_bounds(const JsonNode& node, const std::string& first_extent) {
  const std::string at_least = first_extent + "s_at_least";
  node.require_keys({at_least, "best"}, Extensions::refused);
  MapReport::Bounds bounds{.at_least = node[at_least].count(), .best = {}};
  const JsonNode best = node["best"];
  if (best.is_null()) return bounds;
  best.require_keys({"paths", "places", "count"}, Extensions::refused);
  bounds.best = {best["paths"].count(), best["places"].count(), best["count"].count()};
  return bounds;
}

}  // namespace asterism
