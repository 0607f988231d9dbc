#pragma once

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/tree/map_tree.hpp"
#include "io/json/trace_file.hpp"
#include "tests/support/catch.hpp"

namespace asterism {

inline const std::string folder = ASTERISM_SOURCE_DIR "/tests/traces/";

inline Trace trace(const std::string& name) {
  return read_trace_file(folder + name + ".trace.json");
}

inline nlohmann::json expected() {
  return nlohmann::json::parse(std::ifstream(folder + "expected.json"));
}

/// Sorted, places numbered by first visit.
inline std::vector<std::vector<std::size_t>> minimal_visits(const MapTree& tree) {
  std::vector<std::vector<std::size_t>> result;
  tree.for_each(tree.minimal(), [&](HypothesisId, std::span<const Arrival> arrivals) {
    auto& visits = result.emplace_back();
    for (const Arrival& arrival : arrivals) visits.push_back(arrival.place.index());
  });
  std::sort(result.begin(), result.end());
  return result;
}

inline void check_against(const nlohmann::json& known, const MapTree& tree) {
  CHECK(tree.size() == known.at("consistent"));
  CHECK(std::vector<std::uint64_t>(tree.per_visit().begin(), tree.per_visit().end()) ==
        known.at("per_visit").get<std::vector<std::uint64_t>>());
  CHECK(tree.undecided() == 0);
  const auto& minimal = known.at("minimal");
  CHECK(tree.minimal().size() == minimal.at("count"));
  CHECK(minimal_visits(tree) == minimal.at("visits").get<std::vector<std::vector<std::size_t>>>());
  for (const HypothesisId id : tree.minimal()) {
    const TopologicalMap map = tree.map(id);
    CHECK(map.paths.size() == minimal.at("paths"));
    CHECK(map.places.size() == minimal.at("places"));
  }
}

inline void check_trace(const std::string& name, Check check) {
  const auto known = expected().at(name);
  for (const bool planar : {false, true}) {
    INFO(name << (planar ? ", planar" : ""));
    MapTree tree({.theory = {.planar = planar}, .check = check});
    REQUIRE(tree.extend(trace(name).visits) == MapTree::Growth::complete);
    check_against(known.at(planar ? "planar" : "all"), tree);
  }
}

}  // namespace asterism
