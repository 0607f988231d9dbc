#include "benchmarks/asp_facts.hpp"
#include "tests/engine/command_line.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/support/axiom_files.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

TEST_CASE("the solver keeps the maps that the native engine keeps",
          "[engine][solver][property][slow]") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Trace trace = seeded_walk(seed, 3 + seed % 4).trace;
    INFO(to_keep(seed, trace));
    const bool planar = seed % 3 == 0;
    const std::string optional = seed % 4 == 1   ? "one_segment"
                                 : seed % 4 == 3 ? "one_crossing"
                                                 : "";
    const auto options = [&](Check check) {
      return MapTree::Options{.theory = {.axioms = shipped_with(optional), .planar = planar},
                              .check = check};
    };
    const MapTree native = tree_of(trace, options(Check::native));
    const MapTree both = tree_of(trace, options(Check::both));
    const MapTree solver = tree_of(trace, options(Check::solver));
    CHECK(both.undecided() == 0);
    CHECK(solver.undecided() == 0);
    CHECK(maps_of(both) == maps_of(native));
    CHECK(maps_of(solver) == maps_of(native));
    CHECK(minimal_of(both) == minimal_of(native));
    CHECK(minimal_of(solver) == minimal_of(native));
  }
}

TEST_CASE("native engine and solver agree under every preference",
          "[engine][solver][preference][property][slow]") {
  const std::string preference =
      GENERATE("place path", "segment path", "path segment place", "place", "segment place");
  AxiomFiles files = shipped_files();
  files["preference.smt2"] = "(set-info :minimise (" + preference + "))\n";
  const AxiomSet axioms = AxiomSet::parse(files);
  for (unsigned seed = 0; seed < 12; ++seed) {
    const Trace trace = seeded_walk(seed, 6).trace;
    INFO(to_keep(seed, trace));
    const MapTree native = tree_of(trace, {.theory = {.axioms = axioms}});
    const MapTree solver = tree_of(trace, {.theory = {.axioms = axioms}, .check = Check::solver});
    CHECK(minimal_of(solver) == minimal_of(native));
  }
}

TEST_CASE("clingo counts as the tree does", "[engine][clingo][property][slow]") {
  const std::string maps = ASTERISM_SOURCE_DIR "/benchmarks/maps.lp";
  const std::string minimal = ASTERISM_SOURCE_DIR "/benchmarks/minimal.lp";
  if (!is_installed("clingo")) {
    WARN("clingo is not installed");
    return;
  }
  for (unsigned seed = 0; seed < 100; ++seed) {
    const Trace trace = seeded_walk(seed, 8 + seed % 7).trace;
    INFO(to_keep(seed, trace));
    const MapTree tree = tree_of(trace, false);
    const TopologicalMap best = tree.map(tree.minimal().front());
    const std::string facts = asp_facts(trace);
    CHECK_THAT(output_of("clingo 0 -q " + maps, facts),
               Catch::Contains("Models       : " + std::to_string(tree.size()) + "\n"));
    CHECK_THAT(output_of("clingo 0 -q --opt-mode=optN " + maps + " " + minimal, facts),
               Catch::Contains("Optimization : " + std::to_string(best.paths.size()) + " " +
                               std::to_string(best.places.size()) + "\n"));
  }
}
