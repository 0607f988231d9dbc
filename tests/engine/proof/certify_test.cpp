#include "engine/proof/certify.hpp"

#include <algorithm>

#include "planarity/euler.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/support/axiom_files.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/known_traces.hpp"

using namespace asterism;

namespace {

Stop enough() { return Stop{}.within(60); }  // some tenths of a second are used

using Extents = std::pair<std::size_t, std::size_t>;  ///< paths, places

Extents extents(const Trace& trace, const Association& association) {
  const TopologicalMap map = make_map(trace, association);
  return {map.paths.size(), map.places.size()};
}

/// Every map that is not minimal, all of one size: the next best.
std::vector<Association> next_best(const MapTree& tree) {
  const Extents best = extents(tree.trace(), minimal_of(tree).front());
  std::vector<Association> result;
  Extents least{};
  for (const Association& map : maps_of(tree)) {
    const Extents size = extents(tree.trace(), map);
    if (size == best) continue;
    if (result.empty() || size < least) {
      least = size;
      result.clear();
    }
    if (size == least) result.push_back(map);
  }
  return result;
}

Certificate certify_minimal(const MapTree& tree, bool planar,
                            const AxiomSet& axioms = shipped_with()) {
  return certify(tree.trace(), {axioms, planar}, minimal_of(tree), enough());
}

}  // namespace

TEST_CASE("minimal models of the known traces are certified", "[engine][certify][traces]") {
  const auto known = GENERATE(from_range(known_traces()));
  const bool planar = GENERATE(false, true);
  INFO(known.trace.name << (planar ? ", planar" : ""));
  CHECK(certify_minimal(tree_of(known.trace, planar), planar) == Certificate::shown);
}

TEST_CASE("the solver certifies what the tree finds minimal, and nothing else",
          "[engine][certify][property]") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Trace trace = seeded_walk(seed, 4 + seed % 6).trace;
    INFO(to_keep(seed, trace));
    const bool planar = seed % 2 == 0;
    const MapTree tree = tree_of(trace, planar);
    CHECK(certify_minimal(tree, planar) == Certificate::shown);
    const auto worse = next_best(tree);
    if (!worse.empty())
      CHECK(certify(trace, {shipped_with(), planar}, worse, enough()) == Certificate::refuted);
  }
}

TEST_CASE("planar minimal models are certified where a smaller map is not planar",
          "[engine][certify][planarity][property]") {
  std::size_t found = 0;
  for (unsigned seed = 0; seed < 400 && found < 5; ++seed) {
    const Trace trace = seeded_walk(seed, 8 + seed % 4).trace;
    INFO(to_keep(seed, trace));
    const MapTree all = tree_of(trace, false);
    const MapTree planar = tree_of(trace, true);
    const Association best = minimal_of(planar).front();
    if (extents(trace, minimal_of(all).front()) == extents(trace, best)) continue;
    ++found;
    CHECK(certify_minimal(planar, true) == Certificate::shown);
    CHECK(certify_minimal(all, false) == Certificate::shown);
    // Without planarity a preferred map exists; with it, what is preferred is no model.
    CHECK(certify_minimal(planar, false) == Certificate::refuted);
    CHECK(certify_minimal(all, true) == Certificate::refuted);
  }
  CHECK(found == 5);
}

TEST_CASE("models that are none, or not of one size, are refuted", "[engine][certify][property]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Trace trace = seeded_walk(seed, 6).trace;
    INFO(to_keep(seed, trace));
    const MapTree tree = tree_of(trace, false);
    auto models = minimal_of(tree);
    if (const auto worse = next_best(tree); !worse.empty()) {
      models.push_back(worse.front());
      CHECK(certify(trace, {shipped_with()}, models, enough()) == Certificate::refuted);
    }
    // A travel that returns to where it began.
    Trace two = trace;
    two.visits.erase(two.visits.begin() + 2, two.visits.end());
    const Association broken{{PlaceId(0), {}}, {PlaceId(0), 0}};
    CHECK(certify(two, {shipped_with()}, std::vector<Association>{broken}, enough()) ==
          Certificate::refuted);
  }
}

TEST_CASE("minimal models under other preferences are certified",
          "[engine][certify][preference][property]") {
  const std::string preference =
      GENERATE("place path", "segment path", "path segment place", "place");
  AxiomFiles files = shipped_files();
  files["preference.smt2"] = "(set-info :minimise (" + preference + "))\n";
  const AxiomSet axioms = AxiomSet::parse(files);
  for (unsigned seed = 0; seed < 6; ++seed) {
    const Trace trace = seeded_walk(seed, 8).trace;
    INFO(to_keep(seed, trace));
    const bool planar = seed % 2 == 0;
    const MapTree tree = tree_of(trace, {.theory = {.axioms = axioms, .planar = planar}});
    CHECK(certify_minimal(tree, planar, axioms) == Certificate::shown);
  }
}

TEST_CASE("minimal models are certified with optional axioms and without shipped ones",
          "[engine][certify][axioms][property]") {
  const auto axioms =
      GENERATE(values<AxiomSet>({shipped_with("one_segment"), shipped_with("one_crossing"),
                                 AxiomSet::parse(with_axiom(shipped_files(), "transitive")),
                                 AxiomSet::parse(with_axiom(shipped_files(), "irreflexive"))}));
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Trace trace = seeded_walk(seed, 6).trace;
    INFO(to_keep(seed, trace));
    const MapTree tree = tree_of(trace, {.theory = {.axioms = axioms}, .check = Check::solver});
    CHECK(certify_minimal(tree, false, axioms) == Certificate::shown);
  }
}

TEST_CASE("without time nothing is shown", "[engine][certify]") {
  const Trace trace = seeded_walk(1, 8).trace;
  const MapTree tree = tree_of(trace, false);
  CHECK(certify(trace, {shipped_with()}, minimal_of(tree), Stop{}.within(0)) ==
        Certificate::not_shown);
  CHECK_THROWS_AS(certify(trace, {shipped_with()}, {}, enough()), std::invalid_argument);
}
