#include "engine/ssh/ssh_certify.hpp"
#include "engine/preference.hpp"

#include <algorithm>

#include "engine/ssh/ssh_tree.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/engine/ssh/ssh_reference.hpp"
#include "tests/support/axiom_files.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

Stop enough() { return Stop{}.within(60); }  // some tenths of a second are used

SshTree tree_of(const Experience& experience, bool planar) {
  SshTree tree(experience, {.theory = {.axioms = shipped_with(), .planar = planar}});
  REQUIRE(tree.grow(experience.views.size()) == MapTree::Growth::complete);
  return tree;
}

Certificate certified(const Experience& experience, bool planar, const SshMap& map) {
  return certify(experience, {shipped_with(), planar}, {&map, 1}, enough());
}

}  // namespace

TEST_CASE("the solver certifies the minimal models, and refutes all other maps",
          "[engine][ssh][solver][property]") {
  std::size_t refuted = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Experience seen = seeded_experience(seed, 4 + seed / 4 % 4);
    INFO("seed " << seed);
    const bool planar = seed % 2 == 0;
    const SshTree tree = tree_of(seen, planar);
    const std::vector<SshMap> minimal = tree.minimal();
    CHECK(certify(seen, {shipped_with(), planar}, minimal, enough()) == Certificate::shown);
    const auto best = extents_by_preference(minimal.front(), shipped_with());
    std::size_t asked = 0;
    tree.for_each([&](const SshMap& map) {
      if (extents_by_preference(map, shipped_with()) == best || ++asked > 3) return;
      CHECK(certified(seen, planar, map) == Certificate::refuted);
      ++refuted;
    });
  }
  CHECK(refuted > 50);
}

TEST_CASE("planar minimal models are certified, though smaller maps are not planar",
          "[engine][ssh][solver][planarity]") {
  // Three places, each joined to each of three others: one map of six places, not planar.
  const Experience seen = tour({0, 3, 1, 4, 2, 5, 0, 4, 1, 5, 2, 3});
  const SshTree all = tree_of(seen, false);
  const SshTree planar = tree_of(seen, true);
  REQUIRE(all.minimal().size() == 1);
  REQUIRE(planar.minimal().size() > 1);
  CHECK(certify(seen, {shipped_with(), false}, all.minimal(), enough()) == Certificate::shown);
  CHECK(certify(seen, {shipped_with(), true}, planar.minimal(), enough()) == Certificate::shown);
  CHECK(certify(seen, {shipped_with(), true}, all.minimal(), enough()) == Certificate::refuted);
  CHECK(certify(seen, {shipped_with(), false}, planar.minimal(), enough()) == Certificate::refuted);
}

TEST_CASE("segments can be preferred to be few, too", "[engine][ssh][solver][property]") {
  auto files = shipped_files();
  std::string& preference = files.at("preference.smt2");
  preference.replace(preference.find("(path place)"), 12, "(segment place)");
  const AxiomSet axioms = AxiomSet::parse(files);
  for (unsigned seed = 0; seed < 24; ++seed) {
    const Experience seen = seeded_experience(seed, 5);
    INFO("seed " << seed);
    SshTree tree(seen, {.theory = {.axioms = axioms}});
    REQUIRE(tree.grow(seen.views.size()) == MapTree::Growth::complete);
    const std::vector<SshMap> minimal = tree.minimal();
    CHECK(certify(seen, {axioms, false}, minimal, enough()) == Certificate::shown);
    tree.for_each([&](const SshMap& map) {
      const std::pair size{map.segments.size(), map.number_of_places()};
      const std::pair least{minimal.front().segments.size(), minimal.front().number_of_places()};
      CHECK(size >= least);
      CHECK((size == least) == (std::ranges::find(minimal, map) != minimal.end()));
    });
  }
}

TEST_CASE("a map that breaks an axiom is refuted, and no time shows nothing",
          "[engine][ssh][solver]") {
  const Experience seen{.name = "t", .views = {"a", "a"}, .actions = {{Action::Kind::travel}}};
  const SshMap loop = make_ssh_map(seen, std::vector{DStateId(0), DStateId(0)});
  CHECK(certified(seen, false, loop) == Certificate::refuted);
  const SshMap line = make_ssh_map(seen, std::vector{DStateId(0), DStateId(1)});
  CHECK(certified(seen, false, line) == Certificate::shown);
  CHECK(certify(seen, {}, std::vector{line}, Stop{}.within(0)) == Certificate::not_shown);
  CHECK_THROWS_AS(certify(seen, {}, std::vector<SshMap>{}, Stop{}.within(1)),
                  std::invalid_argument);
}
