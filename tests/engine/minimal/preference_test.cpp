#include <algorithm>
#include <map>

#include "tests/engine/seeded_walk.hpp"
#include "tests/support/axiom_files.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

using Classes = std::vector<std::vector<HypothesisId>>;

// The same, each map written out and counted.
Classes counted(const MapTree& tree) {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<HypothesisId>> classes;
  tree.for_each([&](HypothesisId id, std::span<const Arrival> arrivals) {
    const TopologicalMap map = make_map(tree.trace(), arrivals);
    classes[{map.paths.size(), map.places.size()}].push_back(id);
  });
  Classes result;
  for (const auto& [size, ids] : classes) result.push_back(ids);
  return result;
}

}  // namespace

TEST_CASE("hypotheses come by preference, each once", "[engine][property]") {
  std::size_t most = 0;
  for (unsigned seed = 0; seed < 150; ++seed) {
    const Trace trace = seeded_walk(seed, 5 + seed % 9).trace;
    INFO(to_keep(seed, trace));
    const MapTree tree = tree_of(trace, seed % 2 == 0);
    const Classes classes = tree.by_preference();
    CHECK(classes == counted(tree));
    REQUIRE(!classes.empty());
    CHECK(std::ranges::equal(classes.front(), tree.minimal()));
    most = std::max(most, classes.size());
  }
  CHECK(most > 4);
}

TEST_CASE("optional axioms and the solver sort their maps alike", "[engine]") {
  const Trace trace = seeded_walk(3, 6).trace;
  const MapTree optional = tree_of(trace, {.theory = {.axioms = shipped_with("one_segment")}});
  CHECK(optional.by_preference() == counted(optional));
  // Without axiom (8) paths may close, and are counted from the map.
  const AxiomSet own = AxiomSet::parse(with_axiom(shipped_files(), "irreflexive"));
  const MapTree solver = tree_of(trace, {.theory = {.axioms = own}, .check = Check::solver});
  CHECK(solver.by_preference() == counted(solver));
  CHECK(MapTree().by_preference().empty());
}
