#include "engine/ask/exits.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "benchmarks/traces.hpp"
#include "engine/ask/replay.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

constexpr double rounding = 2e-6;  // expected numbers are given to six decimals
const std::string strange = "a+1 b+1 c+1 d+1 e+1 f+1 g+1 a-1 b-1 c-1 d-1 e-1 f-1 g-1";

using View = std::vector<std::size_t>;
/// Every hypothesis of a trace.
using Lister = std::function<std::vector<Association>(const Trace&)>;

std::vector<Association> all_of_tree(const Trace& trace, bool planar) {
  return maps_of(tree_of(trace, planar));
}

/// A visit come to by the first arm of this star.
Visit coming_in(const Star& star) { return {.star = star, .entered_by = 0}; }

Trace gone_on(Trace trace, std::size_t turn, const Visit& then) {
  Visit& last = trace.visits.back();
  last.left_by = last.star.clockwise(last.entered_by.value_or(0), turn);
  trace.visits.push_back(then);
  return trace;
}

/// Each way in which a place seen so far may look on coming in, and how likely a new place is to.
std::map<View, std::pair<Star, double>> looks_of(const Trace& trace) {
  std::map<View, std::pair<Star, double>> looks;
  const auto visits = static_cast<double>(trace.visits.size());
  for (const Visit& visit : trace.visits) {
    double gateways = 0;
    for (std::size_t i = 0; i < visit.star.size(); ++i) gateways += visit.star.has_gateway(i);
    for (std::size_t i = 0; i < visit.star.size(); ++i)
      if (visit.star.has_gateway(i)) {
        const Star seen = star_as_seen(visit.star, i);
        looks.try_emplace(seen.view(0), seen, 0.0).first->second.second +=
            1 / (visits + 1) / gateways;
      }
  }
  return looks;
}

/// How many ways on each hypothesis has, if this is seen.
std::map<Association, std::size_t> ways_on(const Trace& trace, std::size_t turn, const Star& seen,
                                           const Lister& list) {
  std::map<Association, std::size_t> ways;
  for (Association child : list(gone_on(trace, turn, coming_in(seen)))) {
    child.pop_back();
    ++ways[child];
  }
  return ways;
}

std::size_t total(const std::map<Association, std::size_t>& ways) {
  std::size_t sum = 0;
  for (const auto& [map, number] : ways) sum += number;
  return sum;
}

/// What a list of all maps of all traces that go on by one travel more says of it. Places look like
/// those of `seen_so_far`, which `trace` goes on from.
struct Reference {
  std::map<View, std::uint64_t> left;
  std::map<View, double> chance;
  std::uint64_t open;  ///< left by something never seen
  double expected_left;
};

Reference reference(const Trace& seen_so_far, const Trace& trace, std::size_t turn,
                    const Lister& list) {
  const std::vector<Association> maps = list(trace);
  const auto looks = looks_of(seen_so_far);
  const auto open = ways_on(trace, turn, Star::parse(strange), list);
  Reference result{.left = {}, .chance = {}, .open = total(open), .expected_left = 0};
  std::map<View, std::map<Association, std::size_t>> ways;
  std::map<Association, double> ways_of_map;
  for (const auto& [view, look] : looks) {
    ways[view] = ways_on(trace, turn, look.first, list);
    result.left[view] = total(ways[view]);
    // A place that is new counts once, whatever it looks like.
    for (const auto& [map, number] : ways[view])
      ways_of_map[map] += static_cast<double>(number - open.count(map));
  }
  for (const auto& [map, one] : open) ways_of_map[map] += static_cast<double>(one);
  double sum = 0;
  for (const auto& [view, look] : looks) {
    double& chance = result.chance[view];
    for (const Association& map : maps) {
      const auto found = ways[view].find(map);
      const std::size_t number = found == ways[view].end() ? 0 : found->second;
      const double closures = static_cast<double>(number - open.count(map));
      const double is_new = static_cast<double>(open.count(map));
      chance += (closures + is_new * look.second) / ways_of_map.at(map) /
                static_cast<double>(maps.size());
    }
    result.expected_left += chance * static_cast<double>(result.left[view]);
    sum += chance;
  }
  result.expected_left += (1 - sum) * static_cast<double>(result.open);
  return result;
}

void check_exit(const Exit& exit, const Reference& expected, std::uint64_t maps) {
  CHECK(exit.known + exit.open == maps);
  CHECK(exit.open == expected.open);
  CHECK(std::abs(exit.expected_left - expected.expected_left) <
        rounding + 1e-9 * expected.expected_left);
  std::map<View, std::uint64_t> left = expected.left;
  std::optional<std::uint64_t> anything_else;
  double sum = 0;
  for (const Outlook& outlook : exit.outlooks) {
    sum += outlook.chance;
    if (!outlook.seen) {
      anything_else = outlook.left;
      continue;
    }
    const View view = outlook.seen->view(0);
    REQUIRE(left.contains(view));
    CHECK(outlook.left == left.at(view));
    CHECK(std::abs(outlook.chance - expected.chance.at(view)) < 1e-9);
    left.erase(view);
  }
  CHECK(std::abs(sum - 1) < 1e-9);
  CHECK(anything_else.value_or(0) == expected.open);
  // What is not told apart is something that no map expects.
  for (const auto& [view, number] : left) CHECK(number == expected.open);
}

/// What all maps expect to see at the end of a travel, if that is the same.
std::optional<Star> sure_look(const Trace& trace, std::size_t turn, const Lister& list) {
  const std::size_t maps = list(trace).size();
  for (const auto& [view, look] : looks_of(trace)) {
    if (list(gone_on(trace, turn, coming_in(look.first))).size() != maps) continue;
    if (list(gone_on(trace, turn, coming_in(Star::parse(strange)))).empty()) return look.first;
  }
  return std::nullopt;
}

/// The gateway travelled out of at last, in each of the maps.
std::vector<PlaceArm> gateways(const std::vector<TopologicalMap>& maps, const Turns& turns) {
  std::vector<PlaceArm> result;
  for (const TopologicalMap& map : maps) {
    PlaceArm at{map.visits.back(), map.entered.back().value_or(0)};
    for (std::size_t i = 0;; ++i) {
      at.arm = map.places[at.place.index()].star.clockwise(at.arm, turns[i]);
      if (i + 1 == turns.size()) break;
      const auto segment = std::ranges::find_if(
          map.segments, [&](const auto& one) { return one.first == at || one.second == at; });
      REQUIRE(segment != map.segments.end());
      at = segment->first == at ? segment->second : segment->first;
    }
    result.push_back(at);
  }
  return result;
}

struct Looking {
  const Lister& list;
  std::vector<TopologicalMap> maps;
  std::size_t most_travels;
  std::map<std::vector<PlaceArm>, std::pair<std::size_t, bool>> found = {};  ///< travels, tells

  /// Tries all rows of travels to what is sure, and one more.
  void look(const Trace& trace, const Turns& turns) {
    const Visit& last = trace.visits.back();
    for (std::size_t turn = 0; turn < last.star.size(); ++turn) {
      if (!last.star.has_gateway(last.star.clockwise(last.entered_by.value_or(0), turn))) continue;
      Turns longer = turns;
      longer.push_back(turn);
      const auto sure = sure_look(trace, turn, list);
      const auto [known, is_new] = found.try_emplace(gateways(maps, longer), longer.size(), !sure);
      if (!is_new) known->second.first = std::min(known->second.first, longer.size());
      if (sure && longer.size() < most_travels)
        look(gone_on(trace, turn, coming_in(*sure)), longer);
    }
  }
};

std::vector<TopologicalMap> written(const Trace& trace, const Lister& list) {
  std::vector<TopologicalMap> maps;
  for (const Association& map : list(trace)) maps.push_back(make_map(trace, map));
  return maps;
}

Trace walked(Trace trace, const Turns& turns, const Lister& list) {
  for (std::size_t i = 0; i + 1 < turns.size(); ++i)
    trace = gone_on(trace, turns[i], coming_in(sure_look(trace, turns[i], list).value()));
  return trace;
}

std::size_t check_exits(const Trace& trace, const MapList& maps, const Lister& list) {
  constexpr ExitBounds bounds{.travels = 3};
  const Exits found = exits(maps, bounds).value();
  const auto order = [](const Exit& exit) {
    return std::tuple(!exit.tells, exit.expected_left, exit.turns.size());
  };
  CHECK(std::ranges::is_sorted(found.exits, {}, order));

  Looking looking{list, written(trace, list), bounds.travels};
  looking.look(trace, {});
  for (const Exit& exit : found.exits) {
    const auto same = looking.found.find(gateways(looking.maps, exit.turns));
    REQUIRE(same != looking.found.end());
    CHECK(same->second == std::pair(exit.turns.size(), exit.tells));
    looking.found.erase(same);
    check_exit(exit, reference(trace, walked(trace, exit.turns, list), exit.turns.back(), list),
               maps.size);
  }
  for (const auto& [gateway, how] : looking.found) CHECK((how.first > 1 && !how.second));
  return found.exits.size();
}

}  // namespace

TEST_CASE("exits split the maps as growing on would", "[engine][exits][reference][property]") {
  std::size_t exits_checked = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Trace trace = seeded_walk(seed, seed % 9).trace;
    INFO(to_keep(seed, trace));
    for (const bool planar : {false, true})
      exits_checked += check_exits(trace, all_maps(tree_of(trace, planar)),
                                   [&](const Trace& one) { return all_of_tree(one, planar); });
  }
  CHECK(exits_checked > 2000);
}

TEST_CASE("exits split the maps as brute force says", "[engine][exits][reference][property]") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Trace trace = seeded_walk(seed, 2 + seed % 4).trace;
    INFO(to_keep(seed, trace));
    for (const bool planar : {false, true})
      check_exits(trace, all_maps(tree_of(trace, planar)), [&](const Trace& one) {
        return every_map_by_visit(one, {.planar = planar}).back();
      });
  }
}

TEST_CASE("optional axioms count", "[engine][exits][property]") {
  for (const std::string axiom : {"one_segment", "one_crossing"}) {
    std::size_t differing = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
      const Trace trace = seeded_walk(seed, 9).trace;
      const Lister list = [&](const Trace& one) {
        return maps_of(tree_of(one, {.theory = {.axioms = shipped_with(axiom)}}));
      };
      INFO(axiom << to_keep(seed, trace));
      const MapTree tree = tree_of(trace, {.theory = {.axioms = shipped_with(axiom)}});
      check_exits(trace, all_maps(tree), list);
      const MapTree without = tree_of(trace, false);
      if (exits(tree)->exits.front().expected_left != exits(without)->exits.front().expected_left)
        ++differing;
    }
    CHECK(differing > 0);
  }
}

//   0 --- 1        the robot came back to 0: it knows this segment, and nothing lies behind it
TEST_CASE("what every map knows tells nothing", "[engine][exits]") {
  const Trace trace{.name = "there and back",
                    .visits = {{.star = Star::parse("a+1 a-0"), .left_by = 0},
                               {.star = Star::parse("a+1 a-0"), .entered_by = 0, .left_by = 0},
                               {.star = Star::parse("a+1 a-0"), .entered_by = 0}}};
  const Exits found = exits(tree_of(trace, false)).value();
  REQUIRE(found.exits.size() == 1);
  const Exit& exit = found.exits.front();
  CHECK((!exit.tells && exit.known == 1 && exit.open == 0 && exit.expected_left == 1));
  CHECK(exit.turns == Turns{0});
  REQUIRE(exit.outlooks.size() == 1);
  CHECK(exit.outlooks.front().seen->text() == "a+1 a-0");
  CHECK((exit.outlooks.front().chance == 1 && found.complete));
}

TEST_CASE("an open gateway leads to what was seen or to something else", "[engine][exits]") {
  // Half of the chance is for a place like the one visit, by either gateway; half for another.
  const Trace trace{.name = "one", .visits = {{.star = Star::parse("a+1 b+0 a-1 b-1")}}};
  const Exits found = exits(tree_of(trace, false)).value();
  REQUIRE(found.exits.size() == 3);
  for (const Exit& exit : found.exits) {
    CHECK((exit.tells && exit.open == 1 && exit.expected_left == 1));
    REQUIRE(exit.outlooks.size() == 1);
    CHECK((!exit.outlooks.front().seen && exit.outlooks.front().chance == 1));
  }
}

//   0 --- 1        However often the robot goes round, it may have come to new places each time: no
//   |     |        such ring is certain, so that there would be two ways to what lies behind 3.
//   2 --- 3 ---
TEST_CASE("no exit is listed twice", "[engine][exits][property]") {
  std::size_t far = 0;
  for (unsigned seed = 2; seed < 400; seed += 5) {
    const Trace trace = seeded_walk(seed, 18).trace;
    const MapTree tree = tree_of(trace, true);
    if (tree.size() > 50) continue;
    const auto maps = written(trace, [](const Trace& one) { return all_of_tree(one, true); });
    std::set<std::vector<PlaceArm>> ends;
    INFO(to_keep(seed, trace));
    const Exits found = exits(tree, {.travels = 6}).value();
    for (const Exit& exit : found.exits) {
      CHECK(ends.insert(gateways(maps, exit.turns)).second);
      if (exit.turns.size() > 2) ++far;
    }
  }
  CHECK(far > 20);
}

TEST_CASE("bounds leave exits out, never silently", "[engine][exits][property]") {
  std::size_t cut = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const MapTree tree = tree_of(seeded_walk(seed, 10).trace, true);
    const Exits all = exits(tree, {.travels = 50, .places = 10'000}).value();
    CHECK(all.complete);
    for (const ExitBounds bounds :
         {ExitBounds{.travels = 1}, ExitBounds{.travels = 2}, ExitBounds{.places = 2}}) {
      const Exits some = exits(tree, bounds).value();
      const auto tells = [](const Exit& exit) { return exit.tells; };
      CHECK(std::ranges::count_if(some.exits, tells) <= std::ranges::count_if(all.exits, tells));
      if (some.exits.size() < all.exits.size()) CHECK(!some.complete);
      for (const Exit& exit : some.exits) CHECK(exit.turns.size() <= bounds.travels);
      if (!some.complete) ++cut;
    }
  }
  CHECK(cut > 10);
}

TEST_CASE("looking out stops when it is told to", "[engine][exits]") {
  const MapTree tree = tree_of(make_trace(benchmark_traces[2]), false);
  std::uint64_t looked = 0;
  CHECK(!exits(tree, {}, stop_unless([&](const Standing& now) {
                 looked = now.maps;
                 return looked < 50'000;
               })));
  CHECK(looked >= 50'000);
  CHECK(looked < tree.size());
}

TEST_CASE("a star as seen is the same for the same view", "[engine][exits]") {
  CHECK(star_as_seen(Star::parse("v+1 h+0 v-1 h-1"), 3).text() == "a+1 b+1 a-0 b-1");
  CHECK(star_as_seen(Star::parse("x-1 y+1 y-1 x+0"), 1).text() == "a+1 a-1 b+0 b-1");
  std::vector<Arm> arms;
  for (const char sign : {'+', '-'})
    for (int i = 0; i < 60; ++i) arms.push_back({"p" + std::to_string(i), sign, true});
  for (const std::size_t i : {0U, 59U, 100U})
    CHECK(star_as_seen(Star(arms), i).view(0) == Star(arms).view(i));
}

TEST_CASE("exits split the minimal models as growing these on would, loops and all",
          "[engine][exits][reference][property]") {
  std::size_t exits_checked = 0;
  std::size_t in_loops = 0;
  for (unsigned seed = 0; seed < 150; ++seed) {
    const Trace trace = seeded_walk(seed, 4 + seed % 9).trace;
    INFO(to_keep(seed, trace));
    const bool planar = seed % 3 == 0;
    MinimalSearch search({.axioms = shipped_with(), .planar = planar});
    search.extend(trace.visits);
    search.run();
    const std::vector<Association> models = minimal_of(tree_of(trace, planar));
    REQUIRE(minimal_maps(search).size == models.size());
    exits_checked += check_exits(trace, minimal_maps(search), [&](const Trace& one) {
      std::vector<Association> maps = all_of_tree(one, planar);
      std::erase_if(maps, [&](const Association& map) {
        return !std::ranges::binary_search(
            models, Association(map.begin(),
                                map.begin() + static_cast<std::ptrdiff_t>(trace.visits.size())));
      });
      return maps;
    });
    const auto map = make_map(trace, models.front());
    in_loops += models.size() == 1 && map.segments.size() >= map.places.size();
  }
  CHECK(exits_checked > 500);
  CHECK(in_loops > 10);
}
