#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "engine/map_tree.hpp"
#include "io/trace_file.hpp"
#include "tests/support/axiom_files.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

const std::string folder = ASTERISM_SOURCE_DIR "/tests/traces/";

Trace trace(const std::string& name) { return read_trace_file(folder + name + ".trace.json"); }

nlohmann::json expected() { return nlohmann::json::parse(std::ifstream(folder + "expected.json")); }

/// Sorted, places numbered by first visit.
std::vector<std::vector<std::size_t>> minimal_visits(const MapTree& tree) {
  std::vector<std::vector<std::size_t>> result;
  tree.for_each(tree.minimal(), [&](HypothesisId, std::span<const Arrival> arrivals) {
    auto& visits = result.emplace_back();
    for (const Arrival& arrival : arrivals) visits.push_back(arrival.place.index());
  });
  std::sort(result.begin(), result.end());
  return result;
}

void check_against(const nlohmann::json& known, const MapTree& tree) {
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

void check_trace(const std::string& name, Check check) {
  const auto known = expected().at(name);
  for (const bool planar : {false, true}) {
    INFO(name << (planar ? ", planar" : ""));
    MapTree tree({.planar = planar, .check = check});
    REQUIRE(tree.extend(trace(name).visits) == MapTree::Growth::complete);
    check_against(known.at(planar ? "planar" : "all"), tree);
  }
}

std::uint64_t count(const Trace& trace, const AxiomSet& axioms, bool planar, Check check) {
  MapTree tree({.planar = planar, .check = check, .axioms = axioms});
  REQUIRE(tree.extend(trace.visits) == MapTree::Growth::complete);
  CHECK(tree.undecided() == 0);
  return tree.size();
}

}  // namespace

TEST_CASE("the native engine finds every known number", "[engine][traces]") {
  const auto all = expected();
  for (const auto& [name, known] : all.items()) check_trace(name, Check::native);
}

TEST_CASE("native engine and solver agree on every candidate of the known traces",
          "[engine][traces]") {
  check_trace(GENERATE("eight-crossings", "aces-stubs", "square-three-laps"), Check::both);
}

TEST_CASE("native engine and solver agree on the grids and the other readings of ACES",
          "[engine][traces][slow]") {
  check_trace(GENERATE("grid-4x4-snake", "grid-3x3", "aces-corridors", "aces-lobbies"),
              Check::both);
}

TEST_CASE("a tree grown visit by visit is the tree grown in one pass", "[engine][traces]") {
  const auto all = expected();
  for (const auto& [name, known] : all.items()) {
    MapTree tree({.planar = true});
    for (Visit visit : trace(name).visits) {
      const auto left_by = std::exchange(visit.left_by, std::nullopt);
      REQUIRE(tree.extend(visit) == MapTree::Growth::complete);
      if (left_by) tree.leave(*left_by);
    }
    check_against(known.at("planar"), tree);
  }
}

TEST_CASE("switching axioms changes the counts as is known", "[engine][traces]") {
  struct Variant {
    std::string what;
    AxiomSet axioms;
    std::uint64_t all;
    std::uint64_t planar;
  };
  const auto optional = [](const std::string& name) {
    return AxiomSet::shipped(std::vector{name});
  };
  const auto without = [](const std::vector<std::string>& names) {
    AxiomFiles files = shipped_files();
    for (const std::string& name : names) files = with_axiom(files, name);
    return AxiomSet::parse(files);
  };
  const auto variant = GENERATE_COPY(values<Variant>({
      {"shipped", AxiomSet::shipped(), 83, 46},
      {"one_segment", optional("one_segment"), 77, 45},
      {"one_crossing", optional("one_crossing"), 74, 45},
      {"without transitive", without({"transitive"}), 92, 54},
      {"without irreflexive", without({"irreflexive"}), 120, 68},
      {"without both", without({"irreflexive", "transitive"}), 120, 68},
  }));
  INFO(variant.what);
  const Trace eight = trace("eight-crossings");
  const Check check = variant.axioms.is_shipped() ? Check::both : Check::solver;
  CHECK(count(eight, variant.axioms, false, check) == variant.all);
  CHECK(count(eight, variant.axioms, true, check) == variant.planar);
}
