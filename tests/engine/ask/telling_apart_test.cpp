#include "engine/ask/telling_apart.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "engine/ask/replay.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;
using Answer = TellingApart::Answer;

namespace {

/// The minimal models written out, in the order of reports.
std::vector<TopologicalMap> models_of(const MapTree& tree) {
  std::vector<TopologicalMap> models;
  tree.for_each(tree.minimal(), [&](HypothesisId, std::span<const Arrival> arrivals) {
    models.push_back(make_map(tree.trace(), arrivals));
  });
  std::ranges::sort(models, {},
                    [](const auto& map) { return std::tuple(map.visits, map.entered); });
  return models;
}

/// What a robot in this map sees that goes this way, up to where it does not know or cannot go.
std::vector<std::vector<std::size_t>> simulated(const TopologicalMap& map, const Turns& turns) {
  std::map<PlaceArm, PlaceArm> across;
  for (const auto& [one, other] : map.segments) across.insert({{one, other}, {other, one}});
  std::vector<std::vector<std::size_t>> views;
  PlaceArm at{map.visits.back(), map.entered.back().value_or(0)};
  for (const std::size_t turn : turns) {
    const Star& star = map.places[at.place.index()].star;
    if (turn >= star.size()) break;
    const auto to = across.find({at.place, star.clockwise(at.arm, turn)});
    if (to == across.end()) break;
    at = to->second;
    views.push_back(map.places[at.place.index()].star.view(at.arm));
  }
  return views;
}

/// Whether two robots that go the same way are sure to see something different.
bool differ(const TopologicalMap& one, const TopologicalMap& other, const Turns& turns) {
  const auto views = simulated(one, turns);
  const auto other_views = simulated(other, turns);
  for (std::size_t i = 0; i < std::min(views.size(), other_views.size()); ++i)
    if (views[i] != other_views[i]) return true;
  return false;
}

bool all_differ(const std::vector<TopologicalMap>& models, const Turns& turns) {
  for (std::size_t i = 0; i < models.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!differ(models[i], models[j], turns)) return false;
  return true;
}

/// The first row of so many travels that tells all models apart.
std::optional<Turns> first_of_length(const std::vector<TopologicalMap>& models,
                                     std::size_t length) {
  Turns turns(length);
  constexpr std::size_t arms = 6;  // of no place in these worlds are there more
  while (true) {
    if (all_differ(models, turns)) return turns;
    std::size_t i = length;
    while (i > 0 && turns[i - 1] + 1 == arms) turns[--i] = 0;
    if (i == 0) return std::nullopt;
    ++turns[i - 1];
  }
}

}  // namespace

TEST_CASE("the shortest travels that tell minimal models apart are those of trying all",
          "[engine][telling_apart][reference][property]") {
  constexpr std::size_t most_tried = 4;
  std::map<std::size_t, std::size_t> of_length;
  std::size_t none = 0;
  for (unsigned seed = 0; seed < 500; ++seed) {
    const MapTree tree = tree_of(seeded_walk(seed, 6 + seed % 12).trace, seed % 3 == 0);
    const std::vector<TopologicalMap> models = models_of(tree);
    if (models.size() == 1 || models.size() > 12) continue;
    INFO(to_keep(seed, tree.trace()));
    const TellingApart found = tell_apart(tree);
    const bool is_found = found.answer == Answer::found;
    CHECK((is_found || found.answer == Answer::none));
    for (std::size_t length = 0; length <= most_tried; ++length) {
      const auto first = first_of_length(models, length);
      if (is_found && found.turns.size() == length) CHECK(found.turns == first);
      if (!is_found || found.turns.size() > length) CHECK(!first);
      if (first) break;
    }
    is_found ? ++of_length[found.turns.size()] : ++none;
    if (!is_found) continue;
    CHECK(all_differ(models, found.turns));
    REQUIRE(found.expected.size() == models.size());
    for (std::size_t m = 0; m < models.size(); ++m) {
      const auto views = simulated(models[m], found.turns);
      REQUIRE(found.expected[m].size() <= views.size());
      for (std::size_t i = 0; i < found.expected[m].size(); ++i)
        CHECK(found.expected[m][i].view(0) == views[i]);
    }
  }
  CHECK(none > 20);
  CHECK((of_length[1] > 3 && of_length[2] > 3 && of_length[3] > 3));
}

TEST_CASE("one minimal model needs no travel", "[engine][telling_apart]") {
  const Trace trace{.name = "one", .visits = {{.star = Star::parse("a+1 b+1 a-1 b-1")}}};
  const TellingApart found = tell_apart(tree_of(trace, false));
  CHECK((found.answer == Answer::found && found.turns.empty()));
  CHECK(found.expected == std::vector<std::vector<Star>>{{}});
}

TEST_CASE("a search that ends early says so", "[engine][telling_apart]") {
  std::size_t early = 0;
  for (unsigned seed = 0; seed < 200 && early < 10; ++seed) {
    const MapTree tree = tree_of(seeded_walk(seed, 14).trace, false);
    const TellingApart whole = tell_apart(tree);
    if (tree.minimal().size() == 1 || whole.turns.size() < 2) continue;
    CHECK(tell_apart(tree, 0).answer == Answer::out_of_bounds);
    CHECK(tell_apart(tree, default_most_numbers, stop_unless([] { return false; })).answer ==
          Answer::stopped);
    CHECK(tell_apart(tree, default_most_numbers, stop_unless([] { return true; })).turns ==
          whole.turns);
    ++early;
  }
  CHECK(early == 10);
}
