#include "engine/ask/route.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "benchmarks/traces.hpp"
#include "engine/ask/joint_search.hpp"
#include "engine/ask/query_reader.hpp"
#include "tests/engine/ask/route_reference.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/support/axiom_files.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

RouteQuery route_query(std::size_t from, std::size_t to) {
  return std::get<RouteQuery>(
      read_question("route(" + std::to_string(from) + "," + std::to_string(to) + ")"));
}

struct Shorter {
  Turns route;
  std::uint64_t maps;
  Association witness;
  friend auto operator<=>(const Shorter&, const Shorter&) = default;
};

/// What single maps have that is shorter, most maps first; the maps come in the order of reports.
std::vector<Shorter> shorter_in(const std::vector<Walked>& maps,
                                const std::vector<std::map<std::size_t, Turns>>& best,
                                std::size_t to, std::size_t travels) {
  std::map<Turns, Shorter> counted;
  for (std::size_t m = 0; m < maps.size(); ++m) {
    const auto known = best[m].find(to);
    if (known == best[m].end() || known->second.size() >= travels) continue;
    const Turns& route = known->second;
    ++counted.try_emplace(route, Shorter{route, 0, arrivals(maps[m].map)}).first->second.maps;
  }
  std::vector<Shorter> result;
  for (const auto& [route, shorter] : counted) result.push_back(shorter);
  std::ranges::sort(result, [](const Shorter& one, const Shorter& other) {
    return std::tuple(other.maps, one.route.size(), one.route) <
           std::tuple(one.maps, other.route.size(), other.route);
  });
  return result;
}

std::vector<Shorter> shorter_of(const RouteAnswer& answer) {
  std::vector<Shorter> result;
  for (const auto& [route, maps, witness] : answer.shorter)
    result.push_back({route, maps, witness});
  return result;
}

/// The maps of a tree, in the order of reports.
std::vector<Walked> written(const MapTree& tree, bool only_minimal = false) {
  std::vector<Walked> maps;
  for (const Association& map : only_minimal ? minimal_of(tree) : maps_of(tree))
    maps.emplace_back(make_map(tree.trace(), map));
  std::ranges::sort(maps, [](const Walked& a, const Walked& b) {
    return std::tie(a.map.visits, a.map.entered) < std::tie(b.map.visits, b.map.entered);
  });
  return maps;
}

std::size_t between(std::size_t i, std::size_t j) { return i < j ? j - i : i - j; }

struct Seen {
  std::size_t routes = 0;
  std::size_t shorter_than_trace = 0;
  std::size_t shorter_in_some = 0;
  std::size_t none = 0;
  std::size_t unreachable = 0;
};

/// Whether the answer is what trying all found: `best`, of at most so many travels, and what is
/// best in each map.
bool agrees(const RouteAnswer& answer, const std::vector<Walked>& maps, std::size_t from,
            std::size_t to, std::size_t most_travels, const std::map<std::size_t, Turns>& best,
            const std::vector<std::map<std::size_t, Turns>>& best_of_map) {
  const auto known = best.find(to);
  const std::size_t own = between(from, to);
  if (!answer.is_shortest || answer.of != maps.size() || answer.unlisted != 0) return false;
  if (answer.certain && !leads_in_all(maps, from, to, *answer.certain)) return false;
  // The trace's own way is told where none is shorter; else the first by turns.
  if (known != best.end()) {
    const Turns& route = known->second;
    if (!answer.certain || answer.certain->size() != route.size()) return false;
    if (route.size() < own && answer.certain != route) return false;
  } else if (answer.certain && answer.certain->size() <= most_travels) {
    return false;
  }
  const auto unreachable = static_cast<std::uint64_t>(
      std::ranges::count_if(best_of_map, [&](const auto& of_map) { return !of_map.contains(to); }));
  const Modality modality = unreachable == maps.size() ? Modality::impossible
                            : answer.certain           ? Modality::certain
                                                       : Modality::possible;
  const std::size_t travels = answer.certain ? answer.certain->size() : SIZE_MAX;
  return answer.unreachable == unreachable && answer.modality() == modality &&
         shorter_of(answer) == shorter_in(maps, best_of_map, to, travels);
}

void check_routes(const MapTree& tree, bool only_minimal, Seen& seen) {
  const auto maps = written(tree, only_minimal);
  const std::size_t visits = tree.trace().visits.size();
  std::vector<std::string> differing;
  for (std::size_t from = 0; from < visits; ++from) {
    const std::size_t most_travels = std::max(from, visits - 1 - from);
    const auto best = best_in_all(maps, from, most_travels);
    std::vector<std::map<std::size_t, Turns>> best_of_map;
    for (const Walked& map : maps) best_of_map.push_back(best_in(map, from));
    for (std::size_t to = 0; to < visits; ++to) {
      const RouteAnswer answer = find_route(tree, route_query(from, to), only_minimal).value();
      if (!agrees(answer, maps, from, to, most_travels, best, best_of_map))
        differing.push_back(std::to_string(from) + " to " + std::to_string(to));
      ++seen.routes;
      if (!answer.certain) ++seen.none;
      if (answer.unreachable > 0) ++seen.unreachable;
      if (answer.certain && answer.certain->size() < between(from, to)) ++seen.shorter_than_trace;
      if (!answer.shorter.empty()) ++seen.shorter_in_some;
    }
  }
  CHECK(differing == std::vector<std::string>{});
}

}  // namespace

TEST_CASE("routes are certain and shortest, as trying every row of turns shows",
          "[engine][query][route][reference][property]") {
  Seen seen;
  for (unsigned seed = 0; seed < 500; ++seed) {
    const Trace trace = seeded_walk(seed, 3 + seed % 7).trace;
    INFO(to_keep(seed, trace));
    for (const bool planar : {false, true}) {
      const MapTree tree = tree_of(trace, planar);
      for (const bool only_minimal : {false, true}) check_routes(tree, only_minimal, seen);
    }
  }
  CHECK(seen.none == 0);  // the trace's own way leads there in every map
  CHECK(seen.routes > 20'000);
  CHECK(seen.shorter_than_trace > 2'000);
  CHECK(seen.shorter_in_some > 2'000);
}

TEST_CASE("routes are as sure as axioms of one's own let them be",
          "[engine][query][route][reference]") {
  Seen seen;
  for (const std::string left_out : {"irreflexive", "deterministic"}) {
    const AxiomSet own = AxiomSet::parse(with_axiom(shipped_files(), left_out));
    for (unsigned seed = 0; seed < 12; ++seed) {
      const MapTree tree =
          tree_of(seeded_walk(seed, 5).trace, {.theory = {.axioms = own}, .check = Check::solver});
      INFO(left_out << ", " << to_keep(seed, tree.trace()));
      check_routes(tree, seed % 2 == 0, seen);
    }
  }
  // Where one travel may have two results, what is known may not lead back.
  CHECK(seen.none > 50);
  CHECK(seen.unreachable > 20);
}

TEST_CASE("a route is what searching all maps at once finds", "[engine][query][route][property]") {
  std::size_t shorter = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const MapTree tree = tree_of(seeded_walk(seed, 14 + seed % 4).trace, seed % 2 == 0);
    const std::size_t visits = tree.trace().visits.size();
    if (tree.size() > 3000) continue;
    INFO(to_keep(seed, tree.trace()));
    ArmTable table;
    for (const Visit& visit : tree.trace().visits) table.append(visit);
    for (std::size_t i = 0; i < 6; ++i) {
      const std::size_t from = (3 * i + seed) % visits;
      const std::size_t to = (7 * i + 2 * seed + 5) % visits;
      JointSearch search(VisitId(from), VisitId(to), UINT64_MAX);
      RouteMap map(table);
      tree.for_each([&](HypothesisId, std::span<const Arrival> arrivals) {
        map.set(arrivals);
        search.add(map);
      });
      const auto route = search.shortest(SIZE_MAX);
      const auto answer = find_route(tree, route_query(from, to), false).value();
      REQUIRE((route && answer.certain));
      CHECK(answer.certain->size() == route->size());
      if (route->size() == between(from, to)) continue;
      CHECK(answer.certain == route);
      ++shorter;
    }
  }
  CHECK(shorter > 60);
}

TEST_CASE("among many maps a route is certain in each", "[engine][query][route]") {
  const MapTree tree = tree_of(make_trace(benchmark_traces[0]), false);
  const auto maps = written(tree);
  const RouteAnswer answer = find_route(tree, route_query(24, 2), false).value();
  REQUIRE(answer.certain);
  CHECK((answer.is_shortest && answer.certain->size() < 22));
  CHECK(leads_in_all(maps, 24, 2, *answer.certain));
  std::uint64_t with_shorter = 0;
  for (const Walked& map : maps)
    if (best_in(map, 24).at(2).size() < answer.certain->size()) ++with_shorter;
  std::uint64_t listed = 0;
  for (const auto& some : answer.shorter) listed += some.maps;
  CHECK((listed == with_shorter && answer.unlisted == 0));

  // Not all can be listed, not all tried: what is not known is said.
  const RouteAnswer few = find_route(tree, route_query(24, 2), false, {}, {.routes = 5}).value();
  std::uint64_t kept = 0;
  for (const auto& some : few.shorter) kept += some.maps;
  CHECK(few.shorter.size() <= 5);
  CHECK((few.unlisted > 0 && kept + few.unlisted == with_shorter));
  const RouteAnswer own = find_route(tree, route_query(24, 2), false, {}, {.travels = 100}).value();
  CHECK(!own.is_shortest);
  REQUIRE(own.certain);
  CHECK((own.certain->size() == 22 && leads_in_all(maps, 24, 2, *own.certain)));
}

TEST_CASE("looking for a route stops when it is told to", "[engine][query][route]") {
  const MapTree tree = tree_of(make_trace(benchmark_traces[1]), false);
  std::uint64_t asked = 0;
  CHECK(!find_route(tree, route_query(24, 2), false, stop_unless([&](const Standing& now) {
                      asked = now.maps;
                      return false;
                    })));
  CHECK((asked > 0 && asked < tree.size()));
  // Also while what was found is put to all maps.
  std::size_t times = 0;
  CHECK(!find_route(tree, route_query(24, 2), false,
                    stop_unless([&] { return ++times * 4096 <= tree.size(); })));
}

TEST_CASE("where no map explains the trace, no route leads anywhere", "[engine][query][route]") {
  const Star crossing = Star::parse("a+1 b+1 a-1 b-1");
  const Trace trace{.name = "none",
                    .visits = {{.star = Star::parse("a+1 a-0"), .left_by = 0},
                               {.star = crossing, .entered_by = 0, .left_by = 0},
                               {.star = crossing, .entered_by = 0}}};
  const RouteAnswer answer = find_route(tree_of(trace, false), route_query(0, 2), false).value();
  CHECK((answer.of == 0 && !answer.certain && answer.modality() == Modality::impossible));
}

//         1
//         |
//   0 --- + --- 2      from 0 to the crossing, up and back, and on: straight on is certain
TEST_CASE("a route leaves out what was a detour", "[engine][query][route]") {
  const Star end = Star::parse("a+1 a-0");
  const Star tee = Star::parse("a+1 b+1 a-1 b-0");
  const Trace trace{.name = "detour",
                    .visits = {{.star = end, .left_by = 0},
                               {.star = tee, .entered_by = 0, .left_by = 1},
                               {.star = end, .entered_by = 0, .left_by = 0},
                               {.star = tee, .entered_by = 1, .left_by = 2},
                               {.star = end, .entered_by = 0}}};
  const MapTree tree = tree_of(trace, false);
  CHECK(find_route(tree, route_query(0, 4), false)->certain == Turns{0, 2});
  CHECK(find_route(tree, route_query(4, 0), false)->certain == Turns{0, 2});
  CHECK(find_route(tree, route_query(2, 4), false)->certain == Turns{0, 1});
  CHECK(find_route(tree, route_query(1, 3), false)->certain == Turns{});
}
