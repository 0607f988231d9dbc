#include "core/assumption.hpp"

#include <algorithm>

#include "engine/ask/query_reader.hpp"
#include "engine/proof/certify.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

using Assumptions = std::vector<Assumption>;
using Kind = Assumption::Kind;

Stop enough() { return Stop{}.within(60); }  // some tenths of a second are used

/// One or two, most of which hold in one of the maps and not in all.
Assumptions random_assumptions(const Trace& trace, bool planar, RandomEngine& engine) {
  const auto maps = maps_of(tree_of(trace, planar));
  const Association& map = maps[below(maps.size(), engine)];
  const bool holds_in_map = below(8, engine) > 0;
  const std::size_t tries = 1 + below(40, engine);
  Assumptions result;
  for (std::size_t n = 1 + below(2, engine); n > 0; --n) {
    std::optional<Assumption> drawn;
    for (std::size_t i = 0; i < tries; ++i) {
      const std::size_t one = below(map.size(), engine);
      const std::size_t other = below(map.size(), engine);
      const bool is_same = map[one].place == map[other].place;
      drawn = {is_same == holds_in_map ? Kind::same : Kind::differ, VisitId(one), VisitId(other)};
      if (std::ranges::any_of(maps, [&](const Association& another) {
            return (another[one].place == another[other].place) != is_same;
          }))
        break;
    }
    result.push_back(*drawn);
  }
  return result;
}

/// What a map of the first visits makes of assumptions that name these visits alone.
bool is_as_assumed(const Association& map, const Assumptions& assumptions) {
  for (const auto& [kind, one, other] : assumptions) {
    if (std::max(one.index(), other.index()) >= map.size()) continue;
    const bool is_same = map[one.index()].place == map[other.index()].place;
    if (is_same && kind == Kind::differ) return false;
    if (!is_same && kind == Kind::same) return false;
  }
  return true;
}

std::vector<Association> filtered(std::vector<Association> maps, const Assumptions& assumptions) {
  std::erase_if(maps, [&](const Association& map) { return !is_as_assumed(map, assumptions); });
  return maps;
}

std::pair<std::size_t, std::size_t> size_of(const Trace& trace, const Association& association) {
  const TopologicalMap map = make_map(trace, association);
  return {map.paths.size(), map.places.size()};
}

std::vector<Association> least(const Trace& trace, std::vector<Association> maps) {
  if (maps.empty()) return maps;
  const auto size = [&](const Association& map) { return size_of(trace, map); };
  const auto best = size(*std::ranges::min_element(maps, {}, size));
  std::erase_if(maps, [&](const Association& map) { return size(map) != best; });
  return maps;
}

MapTree assuming(const Trace& trace, bool planar, const Assumptions& assumptions,
                 Check check = Check::native) {
  return tree_of(
      trace, {.theory = {.axioms = shipped_with(), .planar = planar, .assumptions = assumptions},
              .check = check});
}

std::vector<std::uint64_t> per_visit(const MapTree& tree) {
  return {tree.per_visit().begin(), tree.per_visit().end()};
}

}  // namespace

TEST_CASE("under assumptions those maps are left that hold them",
          "[engine][assumption][reference][property]") {
  std::size_t some = 0;
  for (unsigned seed = 0; seed < 500; ++seed) {
    const Trace trace = seeded_walk(seed, 6 + seed % 5).trace;
    RandomEngine engine(seed);
    for (const bool planar : {false, true}) {
      const Assumptions assumptions = random_assumptions(trace, planar, engine);
      INFO(to_keep(seed, trace) << text_of(assumptions));
      const MapTree tree = assuming(trace, planar, assumptions);
      const auto levels = every_map_by_visit(trace, {.planar = planar});
      const auto maps = filtered(levels.back(), assumptions);
      CHECK(maps_of(tree) == maps);
      CHECK(minimal_of(tree) == least(trace, maps));
      std::vector<std::uint64_t> counts;
      for (const auto& level : levels) counts.push_back(filtered(level, assumptions).size());
      CHECK(per_visit(tree) == counts);
      if (!maps.empty() && maps.size() < levels.back().size()) ++some;
    }
  }
  CHECK(some > 150);
}

TEST_CASE("a tree under assumptions grows in any steps, and is the tree without, filtered",
          "[engine][assumption][property]") {
  std::size_t some = 0;
  for (unsigned seed = 0; seed < 500; ++seed) {
    const Trace trace = seeded_walk(seed, 12 + seed % 8).trace;
    RandomEngine engine(seed + 1);
    const bool planar = seed % 2 == 0;
    const Assumptions assumptions = random_assumptions(trace, planar, engine);
    INFO(to_keep(seed, trace) << text_of(assumptions));
    const MapTree whole = assuming(trace, planar, assumptions);
    const auto all = maps_of(tree_of(trace, planar));
    CHECK(maps_of(whole) == filtered(all, assumptions));
    if (whole.size() > 0 && whole.size() < all.size()) ++some;

    MapTree stepwise({.axioms = shipped_with(), .planar = planar, .assumptions = assumptions});
    const std::span<const Visit> visits(trace.visits);
    for (std::size_t k = 0; k < visits.size();) {
      const std::size_t step =
          std::min(seed % 3 == 0 ? 1 : 1 + below(4, engine), visits.size() - k);
      REQUIRE(stepwise.extend(visits.subspan(k, step)) == MapTree::Growth::complete);
      k += step;
    }
    CHECK(per_visit(stepwise) == per_visit(whole));
    CHECK(maps_of(stepwise) == maps_of(whole));
    CHECK(minimal_of(stepwise) == minimal_of(whole));
  }
  CHECK(some > 200);
}

TEST_CASE("the solver keeps the same maps under assumptions", "[engine][assumption][property]") {
  for (unsigned seed = 0; seed < 30; ++seed) {
    const Trace trace = seeded_walk(seed, 6).trace;
    RandomEngine engine(seed);
    const bool planar = seed % 2 == 0;
    const Assumptions assumptions = random_assumptions(trace, planar, engine);
    INFO(to_keep(seed, trace) << text_of(assumptions));
    const Check check = seed % 3 == 0 ? Check::both : Check::solver;
    const MapTree tree = assuming(trace, planar, assumptions, check);
    const MapTree native = assuming(trace, planar, assumptions);
    CHECK(maps_of(tree) == maps_of(native));
    CHECK(per_visit(tree) == per_visit(native));
  }
}

TEST_CASE("minimal models are certified under assumptions, and no others",
          "[engine][assumption][certify][property]") {
  // Of each kind, worlds where every minimal model breaks the assumption, and what is left is
  // larger: the search must not find what it rules out.
  const Kind kind = GENERATE(Kind::same, Kind::differ);
  std::size_t found = 0;
  for (unsigned seed = 0; seed < 300 && found < 4; ++seed) {
    const Trace trace = seeded_walk(seed, 7 + seed % 5).trace;
    const bool planar = seed % 2 == 0;
    const auto free = minimal_of(tree_of(trace, planar));
    RandomEngine engine(seed);
    const Assumptions assumptions{{kind, VisitId(below(trace.visits.size(), engine)),
                                   VisitId(below(trace.visits.size(), engine))}};
    const auto held = minimal_of(assuming(trace, planar, assumptions));
    if (held.empty() || size_of(trace, held.front()) == size_of(trace, free.front())) continue;
    INFO(to_keep(seed, trace) << text_of(assumptions));
    ++found;
    const auto judged = [&](const std::vector<Association>& models, const Assumptions& given) {
      return certify(trace, {shipped_with(), planar, given}, models, enough());
    };
    CHECK(judged(held, assumptions) == Certificate::shown);
    CHECK(judged(free, assumptions) == Certificate::refuted);
    CHECK(judged(held, {}) == Certificate::refuted);
  }
  CHECK(found == 4);
}

TEST_CASE("assumptions that contradict each other leave no map", "[engine][assumption]") {
  const Trace trace = seeded_walk(3, 8).trace;
  const VisitId first(0);
  for (const auto check : {Check::native, Check::solver, Check::both}) {
    const MapTree tree = assuming(
        trace, false, {{Kind::same, first, VisitId(5)}, {Kind::differ, VisitId(5), first}}, check);
    CHECK(tree.size() == 0);
    CHECK(tree.minimal().empty());
    CHECK(tree.per_visit()[4] > 0);
    CHECK(tree.per_visit()[5] == 0);
  }
  CHECK(assuming(trace, false, {{Kind::differ, first, first}}).per_visit()[0] == 0);
  CHECK(assuming(trace, false, {{Kind::same, first, first}}).size() ==
        tree_of(trace, false).size());
}

TEST_CASE("an assumption is read as a query is, and no other query is one",
          "[engine][assumption][query]") {
  const auto stated = read_assumption(" differ( 2 ,5)");
  CHECK(stated.assumption == Assumption{Kind::differ, VisitId(2), VisitId(5)});
  CHECK(text_of(stated.assumption) == "differ(2, 5)");
  CHECK(read_assumption("same(3,9)").assumption == Assumption{Kind::same, VisitId(3), VisitId(9)});
  const auto refusal = [](const std::string& text) -> std::string {
    try {
      read_assumption(text);
    } catch (const QueryError& error) {
      return error.what() + std::string("\n") + error.excerpt();
    }
    return "";
  };
  CHECK(refusal("same(3)") == "assumption, character 7: found ')'; expected ','\nsame(3)\n      ^");
  CHECK(refusal("adjacent(3, 9)") ==
        "assumption, character 1: found 'adjacent'; expected same or differ\nadjacent(3, 9)\n^");
  CHECK(refusal("same(3, 9) and same(1, 2)") ==
        "assumption, character 12: found 'and'; expected the end\n"
        "same(3, 9) and same(1, 2)\n           ^");
  CHECK(refusal("same(3, #)").starts_with("assumption, character 9: found '#'; expected a name"));
  CHECK(refusal(std::string(5000, ' ')).starts_with("assumption, character 4097: "));
  CHECK(refusal("not same(1, 2)").starts_with("assumption, character 1: found 'not'"));
  const Trace trace = seeded_walk(3, 8).trace;
  CHECK_NOTHROW(require_visits(read_assumption("same(0, 8)"), trace));
  CHECK_THROWS_WITH(require_visits(read_assumption("same(0, 9)"), trace),
                    "assumption, character 9: found visit 9; expected 0 to 8");
}
