#include "tests/support/known_traces.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

namespace asterism {
namespace {

using nlohmann::json;

const std::string folder = ASTERISM_SOURCE_DIR "/tests/traces/";

json read_json(const std::string& name) {
  std::ifstream file(folder + name);
  return json::parse(file);
}

std::optional<std::size_t> arm(const json& visit, const char* key, const Star& star) {
  if (!visit.contains(key)) return std::nullopt;
  return star.find(visit.at(key).get<std::string>()).value();
}

Trace read_trace(const std::string& name) {
  Trace trace{.name = name, .visits = {}};
  const json file = read_json(name + ".trace.json");
  for (const json& visit : file.at("visits")) {
    const Star star = Star::parse(visit.at("star").get<std::string>());
    trace.visits.push_back({.star = star,
                            .entered_by = arm(visit, "entered_by", star),
                            .left_by = arm(visit, "left_by", star)});
  }
  return trace;
}

KnownCounts read_counts(const json& counts) {
  const json& minimal = counts.at("minimal");
  return {counts.at("consistent"), counts.at("per_visit"), minimal.at("paths"),
          minimal.at("places"), minimal.at("visits")};
}

}  // namespace

std::vector<KnownTrace> known_traces() {
  std::vector<KnownTrace> result;
  const json file = read_json("expected.json");
  for (const auto& [name, expected] : file.items())
    result.push_back({read_trace(name), read_counts(expected.at("all")),
                      read_counts(expected.at("planar")), expected.at("true_map")});
  return result;
}

}  // namespace asterism
