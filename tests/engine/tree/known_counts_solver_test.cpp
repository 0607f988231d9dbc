#include "tests/engine/tree/known_counts.hpp"
#include "tests/support/axiom_files.hpp"

using namespace asterism;

namespace {

std::uint64_t count(const Trace& trace, const AxiomSet& axioms, bool planar, Check check) {
  MapTree tree({.theory = {.axioms = axioms, .planar = planar}, .check = check});
  REQUIRE(tree.extend(trace.visits) == MapTree::Growth::complete);
  CHECK(tree.undecided() == 0);
  return tree.size();
}

}  // namespace

TEST_CASE("native engine and solver agree on every candidate of the known traces",
          "[engine][traces]") {
  check_trace(GENERATE("eight-crossings", "aces-stubs", "square-three-laps"), Check::both);
}

TEST_CASE("native engine and solver agree on the grids and the other readings of ACES",
          "[engine][traces]") {
  check_trace(GENERATE("grid-4x4-snake", "grid-3x3", "aces-corridors", "aces-lobbies"),
              Check::both);
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
