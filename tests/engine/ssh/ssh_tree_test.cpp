#include "engine/ssh/ssh_tree.hpp"

#include <algorithm>
#include <set>

#include "core/random.hpp"
#include "planarity/boyer_myrvold.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/engine/ssh/ssh_reference.hpp"
#include "tests/engine/ssh/ssh_trees.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

using Growth = MapTree::Growth;

}  // namespace

//   a --- b     to b and back: turned around at both ends, the robot must be where it began
//
TEST_CASE("a travel back leads back once both ends are turned around", "[engine][ssh]") {
  const SshTree back =
      tree_of(experience("a travel b turn_around B travel A turn_around a"), options(false));
  // Known only from the last view on: it may as well be another place that looks the same.
  CHECK(counts_of(back) == std::vector<std::uint64_t>{1, 1, 1, 1, 2});
  CHECK(maps_of(back) == std::vector<Naming>{{0, 1, 2, 3, 0}, {0, 1, 2, 3, 4}});
  const SshTree known = tree_of(experience("a turn_around A turn_around a travel b turn_around B "
                                           "travel A"),
                                options(false));
  const auto maps = maps_of(known);
  for (const Naming& naming : maps)
    if (naming[2] == 0) CHECK(naming[5] == naming[1]);
}

TEST_CASE("a travel never leads to the place it began at", "[engine][ssh]") {
  //   All views alike: the second is new, and the third, which a turn leads to, is not the first.
  CHECK(maps_of(tree_of(experience("a travel a turn:left a"), options(false))) ==
        std::vector<Naming>{{0, 1, 1}, {0, 1, 2}});
  // Round and round one path: order is transitive.
  CHECK(maps_of(tree_of(experience("a travel b travel a"), options(false))) ==
        std::vector<Naming>{{0, 1, 2}});
}

TEST_CASE("a known result leads where it led, or explains nothing", "[engine][ssh]") {
  CHECK(maps_of(tree_of(experience("a turn:left b turn:left a turn:left b"), options(false))) ==
        std::vector<Naming>{{0, 1, 0, 1}, {0, 1, 2, 1}, {0, 1, 2, 3}});
  // Turns of other names lead elsewhere, or not.
  CHECK(tree_of(experience("a turn:left b turn:right a turn:right b"), options(false)).size() == 4);
}

TEST_CASE("the tree holds every partition that forward chaining does not refute",
          "[engine][ssh][reference][property]") {
  std::size_t maps = 0;
  for (unsigned seed = 0; seed < 500; ++seed) {
    const Experience seen = seeded_experience(seed, 4 + seed / 4 % 4);
    INFO(to_keep(seed, seen));
    const SshTree tree = tree_of(seen, options(false));
    const std::vector<Naming> every = every_ssh_map(seen);
    CHECK(maps_of(tree) == every);
    maps += every.size();

    std::vector<Naming> minimal;
    std::pair<std::size_t, std::size_t> least;
    for (const Naming& naming : every) {
      const auto extents = plain_extents(seen, naming);
      if (minimal.empty() || extents < least) {
        minimal.clear();
        least = extents;
      }
      if (extents == least) minimal.push_back(naming);
    }
    CHECK(minimal_of(tree) == minimal);
  }
  CHECK(maps > 2000);
}

namespace {

bool is_among(const Naming& naming, const std::vector<Naming>& maps) {
  return std::ranges::find(maps, naming) != maps.end();
}

}  // namespace

//  0   1   2     each joined to each of    3   4   5: it cannot be drawn in the plane
//
TEST_CASE("planar maps are those that some embedding has", "[engine][ssh][planarity]") {
  const Experience seen = tour({0, 3, 1, 4, 2, 5, 0, 4, 1, 5, 2, 3});
  const SshTree all = tree_of(seen, options(false));
  const SshTree planar = tree_of(seen, options(true));
  std::vector<Naming> drawn;
  for (const Naming& naming : maps_of(all))
    if (has_plane_embedding(seen, naming)) drawn.push_back(naming);
  CHECK(maps_of(planar) == drawn);
  CHECK(planar.size() == drawn.size());
  CHECK(is_among(of_few_dstates(seen), maps_of(all)));
  CHECK_FALSE(is_among(of_few_dstates(seen), drawn));
}

TEST_CASE("planar maps of other tours are those that some embedding has",
          "[engine][ssh][planarity][property]") {
  std::size_t dropped = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    RandomEngine engine(seed);
    // The tour above, but for two places of it.
    std::vector<std::size_t> places{0, 3, 1, 4, 2, 5, 0, 4, 1, 5, 2, 3};
    for (std::size_t changed = 0; changed < 2;) {
      const std::size_t at = 1 + below(places.size() - 2, engine);
      const std::size_t other = below(6, engine);
      if (other == places[at - 1] || other == places[at + 1]) continue;
      places[at] = other;
      ++changed;
    }
    const Experience seen = tour(places);
    INFO("seed " << seed);
    const SshTree all = tree_of(seen, options(false));
    std::vector<Naming> drawn;
    for (const Naming& naming : maps_of(all))
      if (has_plane_embedding(seen, naming)) drawn.push_back(naming);
    CHECK(maps_of(tree_of(seen, options(true))) == drawn);
    dropped += all.size() - drawn.size();
  }
  CHECK(dropped > 0);
}

TEST_CASE("a turn that shows two places to be one can make a map planar again",
          "[engine][ssh][planarity]") {
  Experience seen = tour({0, 3, 1, 4, 2, 5, 0, 4, 1, 5, 2, 3, 0});
  SshTree tree(seen, options(true));
  REQUIRE(tree.grow(seen.views.size()) == Growth::complete);
  CHECK_FALSE(is_among(of_few_dstates(seen), maps_of(tree)));
  seen.actions.push_back({Action::Kind::turn, "over"});
  seen.views.emplace_back("place1");
  SshTree over(seen, options(true));
  REQUIRE(over.grow(seen.views.size() - 1) == Growth::complete);
  REQUIRE(over.grow(1) == Growth::complete);
  CHECK(is_among(of_few_dstates(seen), maps_of(over)));
  CHECK(maps_of(over) == maps_of(tree_of(seen, options(true))));
}

TEST_CASE("graphs are planar if some order of edges round the vertices says so", "[planarity]") {
  std::size_t planar = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    RandomEngine engine(seed);
    const std::size_t vertices = 6 + below(2, engine);
    std::set<std::pair<std::size_t, std::size_t>> edges;
    while (edges.size() < 8 + seed % 4) {
      const std::size_t a = below(vertices, engine);
      const std::size_t b = below(vertices, engine);
      if (a != b) edges.insert(std::minmax(a, b));
    }
    const std::vector<std::pair<std::size_t, std::size_t>> list(edges.begin(), edges.end());
    INFO(seed);
    const bool is_planar = is_planar_graph(vertices, list);
    CHECK(is_planar == has_plane_embedding(vertices, list));
    planar += is_planar ? 1U : 0U;
  }
  CHECK(planar > 50);
  CHECK(planar < 295);
}

TEST_CASE("growing view by view gives what growing in one pass gives", "[engine][ssh][property]") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Experience seen = seeded_experience(seed, 7);
    INFO(to_keep(seed, seen));
    const SshTree once = tree_of(seen, options(false));
    SshTree stepwise(seen, options(false));
    for (std::size_t k = 0; k < seen.views.size(); ++k) {
      REQUIRE(stepwise.grow(1) == Growth::complete);
      CHECK(stepwise.size() == once.per_view()[k]);
    }
    CHECK(maps_of(stepwise) == maps_of(once));
    CHECK(stepwise.grow(0) == Growth::complete);
    CHECK_THROWS_AS(stepwise.grow(1), std::invalid_argument);
  }
}

TEST_CASE("limits stop the growth and leave the tree as it was", "[engine][ssh]") {
  // Turns alone, each of its own name: nothing is known, and every partition is consistent.
  Experience seen{.name = "t", .views = {"a"}, .actions = {}};
  for (std::size_t k = 1; k < 10; ++k) {
    seen.views.emplace_back("a");
    seen.actions.push_back({Action::Kind::turn, std::to_string(k)});
  }
  const SshTree all = tree_of(seen, options(false));
  CHECK(counts_of(all) ==
        std::vector<std::uint64_t>{1, 2, 5, 15, 52, 203, 877, 4140, 21147, 115975});

  MapTree::Options few = options(false);
  few.max_hypotheses = all.size() - 1;
  SshTree limited(seen, few);
  CHECK(limited.grow(9) == Growth::complete);
  const auto before = maps_of(limited);
  CHECK(limited.grow(1) == Growth::too_many);
  CHECK(maps_of(limited) == before);
  CHECK(limited.views() == 9);

  SshTree never(seen, options(false));
  CHECK(never.grow(10, stop_unless([] { return false; })) == Growth::stopped);
  CHECK(never.views() == 0);
  CHECK(never.size() == 0);
}

//   a,e >==== two segments ====> b,f       as far as the last view is taken to be the second
//
TEST_CASE("optional axioms forbid a second segment, and paths that meet twice",
          "[engine][ssh][axioms]") {
  const Experience seen =
      experience("a travel b turn:left c travel d turn:left a turn:left e travel f turn:left b");
  const Naming twice{0, 1, 2, 3, 0, 4, 5, 1};
  const auto holds = [&](const std::string& optional) {
    const auto maps = maps_of(tree_of(seen, options(false, Check::both, optional)));
    return std::ranges::find(maps, twice) != maps.end();
  };
  CHECK(holds(""));
  CHECK_FALSE(holds("one_segment"));
  CHECK_FALSE(holds("one_crossing"));
}

TEST_CASE("an experience can be long, and not too long", "[engine][ssh]") {
  Experience seen{.name = "t", .views = {"0"}, .actions = {}};
  while (seen.views.size() < 400) {
    seen.actions.push_back({Action::Kind::travel});
    seen.views.push_back(std::to_string(seen.views.size()));
  }
  CHECK(tree_of(seen, options(false)).size() == 1);
  while (seen.views.size() < 1001) {
    seen.actions.push_back({Action::Kind::travel});
    seen.views.push_back(std::to_string(seen.views.size()));
  }
  CHECK_THROWS_WITH(SshTree(seen, options(false)),
                    "experience: found more than 1000 views; expected fewer");
  seen.views.pop_back();
  CHECK_THROWS_AS(SshTree(seen, options(false)), std::invalid_argument);
}

TEST_CASE("other axioms than the shipped ones need the solver", "[engine][ssh]") {
  auto files = AxiomSet::built_in_files();
  std::erase_if(files, [](const auto& file) { return file.first.starts_with("optional"); });
  std::string& topological = files.at("topological.smt2");
  topological.erase(
      topological.find("(assert (! (forall ((q DState) (r DState))\n"
                       "               (=> (order q r) (not"));
  MapTree::Options loose{.theory = {.axioms = AxiomSet::parse(files)}, .check = Check::solver};
  const Experience seen = experience("a travel a");
  CHECK(maps_of(tree_of(seen, loose)) == std::vector<Naming>{{0, 0}, {0, 1}});
  loose.check = Check::native;
  CHECK_THROWS_AS(SshTree(seen, loose), std::invalid_argument);
}
