#include "engine/ssh/ssh_engines.hpp"

#include <algorithm>
#include <array>

#include "tests/axioms/forward_chaining.hpp"
#include "tests/axioms/plain_logic.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/engine/ssh/ssh_reference.hpp"
#include "tests/engine/ssh/ssh_trees.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

TEST_CASE("forward chaining refutes what every instance of the axioms refutes",
          "[engine][ssh][reference]") {
  for (unsigned seed = 0; seed < 12; ++seed) {
    const Experience seen = seeded_experience(seed, 4);
    INFO(to_keep(seed, seen));
    for (const Naming& naming : every_partition(4)) {
      const std::vector<Fact> facts = plain_facts(seen, naming);
      CHECK(plain_verdict(shipped_with(), facts) == ForwardChaining(facts).verdict());
    }
  }
}

TEST_CASE("the solver, asked for every dstate, keeps what the native engine keeps",
          "[engine][ssh][solver][property]") {
  for (unsigned seed = 0; seed < 90; ++seed) {
    const Experience seen = seeded_experience(seed, 4 + seed / 4 % 3);
    INFO(to_keep(seed, seen));
    const bool planar = seed % 2 == 0;
    const std::string optional = seed % 5 == 3   ? "one_segment"
                                 : seed % 5 == 4 ? "one_crossing"
                                                 : "";
    const SshTree native = tree_of(seen, options(planar, Check::native, optional));
    const SshTree solver = tree_of(seen, options(planar, Check::solver, optional));
    CHECK(solver.undecided() == 0);
    CHECK(maps_of(solver) == maps_of(native));
    CHECK(counts_of(solver) == counts_of(native));
    CHECK(minimal_of(solver) == minimal_of(native));
    CHECK(maps_of(tree_of(seen, options(planar, Check::both, optional))) == maps_of(native));
  }
}

TEST_CASE("a difference stops the run with the shortest experience that shows it",
          "[engine][ssh][solver]") {
  // The native engine is told of an axiom that the solver is not told of.
  const SshTable table(
      experience("a travel b turn:left c travel d turn:left a turn:left e travel f turn:left b "
                 "travel g"));
  SshBoth engine(SshNative(table, {.one_segment = true}), SshSolver(table, shipped_with()));
  engine.reset({});
  for (const VisitId k : IdRange<VisitId>(7)) {
    const DStateId dstate(std::array{0U, 1U, 2U, 3U, 0U, 4U, 5U}[k.index()]);
    const auto children = children_of(engine, k);
    REQUIRE(std::ranges::find(children, dstate) != children.end());
    engine.enter(k, dstate, engine.step(k, dstate));
  }
  try {
    children_of(engine, VisitId(7));
    FAIL("no difference");
  } catch (const DifferenceError& error) {
    CHECK(error.what() ==
          std::string("native and solver differ: view 7 at dstate 1 is inconsistent to the native "
                      "engine and consistent to the solver"));
    CHECK(std::get<Experience>(error.shortest).views.size() == 8);
    CHECK(std::get<Experience>(error.shortest).actions.size() == 7);
  }
}
