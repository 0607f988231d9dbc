#include "io/json/report_json.hpp"

#include <algorithm>

#include "io/json/assumption_json.hpp"

namespace asterism {
namespace {

using Extensions = JsonNode::Extensions;

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
  node.require_keys(
      {"planar", "check", "axioms", "optional_axioms", "preference", "certify_s", "max_hypotheses",
       "time_limit_s", "all", "memory_limit_bytes", "method", "assumptions"},
      Extensions::refused);
  MapOptions options;
  options.theory.planar = node["planar"].boolean();
  options.check = node["check"].string();
  if (options.check != "native" && options.check != "solver" && options.check != "both")
    node["check"].refuse("\"native\", \"solver\" or \"both\"");
  options.theory.axioms = node["axioms"].string();
  if (options.theory.axioms.empty()) node["axioms"].refuse("\"shipped\" or a directory");
  options.theory.optional_axioms = read_names(node["optional_axioms"]);
  options.theory.preference = read_names(node["preference"]);
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
    options.theory.assumptions = read_assumptions(assumed);
  return options;
}

std::optional<Findings::Minimal> read_minimal(const JsonNode& node) {
  if (node.is_null()) return std::nullopt;
  node.require_keys({"paths", "places", "count", "certified"}, Extensions::refused);
  return Findings::Minimal{node["paths"].count(), node["places"].count(), node["count"].count(),
                           node["certified"].boolean()};
}

}  // namespace

void write_options(JsonWriter& json, const MapOptions& options) {
  json.object([&] {
    json.member("planar", options.theory.planar);
    json.member("check", options.check);
    json.member("axioms", options.theory.axioms);
    json.member("optional_axioms", options.theory.optional_axioms);
    json.member("preference", options.theory.preference);
    json.member("certify_s", options.certify_s);
    json.member("max_hypotheses", options.max_hypotheses);
    json.member("time_limit_s", options.time_limit_s);
    json.member("all", options.all);
    json.member_if("memory_limit_bytes", options.memory_limit_bytes);
    json.member_if("method", options.method);
    if (!options.theory.assumptions.empty())
      json.member("assumptions", assumption_texts(options.theory.assumptions));
  });
}

void write_counts(JsonWriter& json, const Findings& found, std::string_view key) {
  json.line().member("consistent", found.consistent);
  json.line().member(key, found.per_visit);
  json.line().member("complete", found.complete);
  json.member_if("stopped_by", found.stopped_by);
}

void write_minimal(JsonWriter& json, const std::optional<Findings::Minimal>& minimal) {
  if (!minimal) return json.null();
  json.object([&] {
    json.member("paths", minimal->paths);
    json.member("places", minimal->places);
    json.member("count", minimal->count);
    json.member("certified", minimal->certified);
  });
}

Findings read_findings(const JsonNode& root, std::string_view key, const std::string& step) {
  Findings found{.trace = root["trace"].string(), .options = read_options(root["options"])};
  if (const auto number = root["consistent"]; !number.is_null()) found.consistent = number.count();
  if (const auto numbers = root[key]; !numbers.is_null()) {
    found.per_visit.emplace();
    for (const JsonNode& number : numbers.items()) found.per_visit->push_back(number.count());
    if (found.per_visit->empty()) numbers.refuse("an empty array", "a number " + step);
  }
  found.complete = root["complete"].boolean();
  if (const auto reason = root["stopped_by"]; reason.exists() == found.complete)
    reason.refuse(found.complete ? "it only where complete is false" : "a string");
  else if (reason.exists())
    found.stopped_by = reason.string();
  found.minimal = read_minimal(root["minimal"]);
  return found;
}

void write_bounds(JsonWriter& json, const Findings::Bounds& bounds,
                  const std::string& first_extent) {
  json.object([&] {
    json.member(first_extent + "s_at_least", bounds.at_least);
    json.key("best");
    if (!bounds.best) return json.null();
    json.object([&] {
      json.member("paths", bounds.best->paths);
      json.member("places", bounds.best->places);
      json.member("count", bounds.best->count);
    });
  });
}

Findings::Bounds read_bounds(const JsonNode& node, const std::string& first_extent) {
  const std::string at_least = first_extent + "s_at_least";
  node.require_keys({at_least, "best"}, Extensions::refused);
  Findings::Bounds bounds{.at_least = node[at_least].count(), .best = {}};
  const JsonNode best = node["best"];
  if (best.is_null()) return bounds;
  best.require_keys({"paths", "places", "count"}, Extensions::refused);
  bounds.best = {best["paths"].count(), best["places"].count(), best["count"].count()};
  return bounds;
}

}  // namespace asterism
