#include "engine/route.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <tuple>

#include "benchmarks/traces.hpp"
#include "core/error.hpp"
#include "engine/query_reader.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/support/axiom_files.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

RouteQuery route_query(std::size_t from, std::size_t to) {
  return std::get<RouteQuery>(
      read_question("route(" + std::to_string(from) + "," + std::to_string(to) + ")"));
}

/// The robot in a map written out: at a place, in by an arm of its star.
using Standing = PlaceArm;

Standing standing_at(const TopologicalMap& map, std::size_t visit) {
  return {map.visits[visit], map.entered[visit].value_or(0)};
}

/// Where one turn and travel lead, told from the list of segments.
std::optional<Standing> step(const TopologicalMap& map, Standing at, std::size_t turn) {
  const std::size_t size = map.places[at.place.index()].star.size();
  if (turn >= size) return std::nullopt;
  const PlaceArm left{at.place, (at.arm + turn) % size};
  for (const auto& [one, other] : map.segments) {
    if (one == left) return other;
    if (other == left) return one;
  }
  return std::nullopt;
}

std::optional<PlaceId> walk(const TopologicalMap& map, std::size_t from, const Turns& route) {
  Standing at = standing_at(map, from);
  for (const std::size_t turn : route) {
    const auto next = step(map, at, turn);
    if (!next) return std::nullopt;
    at = *next;
  }
  return at.place;
}

bool leads_in_all(const std::vector<TopologicalMap>& maps, std::size_t from, std::size_t to,
                  const Turns& route) {
  return std::ranges::all_of(
      maps, [&](const TopologicalMap& map) { return walk(map, from, route) == map.visits[to]; });
}

/// Fewer travels first, then the first by turns.
bool is_better(const Turns& one, const Turns& other) {
  return std::pair(one.size(), one) < std::pair(other.size(), other);
}

void keep_better(std::map<std::size_t, Turns>& best, std::size_t to, const Turns& route) {
  const auto [known, is_new] = best.try_emplace(to, route);
  if (!is_new && is_better(route, known->second)) known->second = route;
}

/// Tries every row of turns, up to so many, that can be gone in all of these maps, and keeps the
/// best that ends at the place of each visit in all. Forgets nothing and expects nothing:
/// 3^travels.
void try_all(const std::vector<TopologicalMap>& maps, const std::vector<Standing>& at,
             std::size_t most_travels, Turns& route, std::map<std::size_t, Turns>& best) {
  for (std::size_t to = 0; to < maps.front().visits.size(); ++to) {
    bool is_there = true;
    for (std::size_t m = 0; is_there && m < maps.size(); ++m)
      is_there = at[m].place == maps[m].visits[to];
    if (is_there) keep_better(best, to, route);
  }
  if (route.size() == most_travels) return;
  for (std::size_t turn = 0; turn < maps.front().places[at.front().place.index()].star.size();
       ++turn) {
    std::vector<Standing> next;
    for (std::size_t m = 0; m < maps.size(); ++m) {
      const auto there = step(maps[m], at[m], turn);
      if (!there) break;
      next.push_back(*there);
    }
    if (next.size() < maps.size()) continue;
    route.push_back(turn);
    try_all(maps, next, most_travels, route, best);
    route.pop_back();
  }
}

std::map<std::size_t, Turns> best_in_all(const std::vector<TopologicalMap>& maps, std::size_t from,
                                         std::size_t most_travels) {
  std::map<std::size_t, Turns> best;
  std::vector<Standing> at;
  for (const TopologicalMap& map : maps) at.push_back(standing_at(map, from));
  Turns route;
  try_all(maps, at, most_travels, route, best);
  return best;
}

/// The best route to each visit in one map: level by level, all that end there kept until the level
/// is whole.
std::map<std::size_t, Turns> best_in(const TopologicalMap& map, std::size_t from) {
  std::map<std::size_t, Turns> best;
  std::set<PlaceId> seen;
  std::map<Standing, Turns> level{{standing_at(map, from), {}}};
  while (!level.empty()) {
    std::map<Standing, Turns> next;
    for (const auto& [at, route] : level) {
      for (std::size_t to = 0; to < map.visits.size(); ++to)
        if (map.visits[to] == at.place) keep_better(best, to, route);
      if (seen.contains(at.place)) continue;
      for (std::size_t turn = 0; turn < map.places[at.place.index()].star.size(); ++turn) {
        const auto there = step(map, at, turn);
        if (!there) continue;
        Turns longer = route;
        longer.push_back(turn);
        const auto [known, is_new] = next.try_emplace(*there, longer);
        if (!is_new && longer < known->second) known->second = longer;
      }
    }
    // A place come to by two arms is gone on from by each: on the next level it is seen.
    for (const auto& [at, route] : level) seen.insert(at.place);
    level = std::move(next);
  }
  return best;
}

struct Shorter {
  Turns route;
  std::uint64_t maps;
  Association witness;
  friend auto operator<=>(const Shorter&, const Shorter&) = default;
};

/// What single maps have that is shorter, most maps first; the maps come in the order of reports.
std::vector<Shorter> shorter_in(const std::vector<TopologicalMap>& maps,
                                const std::vector<std::map<std::size_t, Turns>>& best,
                                std::size_t to, std::size_t travels) {
  std::map<Turns, Shorter> counted;
  for (std::size_t m = 0; m < maps.size(); ++m) {
    const Turns& route = best[m].at(to);
    if (route.size() >= travels) continue;
    ++counted.try_emplace(route, Shorter{route, 0, arrivals(maps[m])}).first->second.maps;
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

std::vector<TopologicalMap> written(const MapTree& tree, bool only_minimal = false) {
  std::vector<TopologicalMap> maps;
  for (const Association& map : only_minimal ? minimal_of(tree) : maps_of(tree))
    maps.push_back(make_map(tree.trace(), map));
  std::ranges::sort(maps, [](const TopologicalMap& a, const TopologicalMap& b) {
    return std::tie(a.visits, a.entered) < std::tie(b.visits, b.entered);
  });
  return maps;
}

std::size_t between(std::size_t i, std::size_t j) { return i < j ? j - i : i - j; }

struct Seen {
  std::size_t routes = 0;
  std::size_t shorter_than_trace = 0;
  std::size_t shorter_in_some = 0;
};

void check_routes(const MapTree& tree, bool only_minimal, Seen& seen) {
  const auto maps = written(tree, only_minimal);
  const std::size_t visits = tree.trace().visits.size();
  std::vector<std::string> differing;
  for (std::size_t from = 0; from < visits; ++from) {
    const auto best = best_in_all(maps, from, std::max(from, visits - 1 - from));
    std::vector<std::map<std::size_t, Turns>> best_of_map;
    for (const TopologicalMap& map : maps) best_of_map.push_back(best_in(map, from));
    for (std::size_t to = 0; to < visits; ++to) {
      const RouteAnswer answer = find_route(tree, route_query(from, to), only_minimal).value();
      const std::size_t own = between(from, to);
      const bool is_right =
          answer.of == maps.size() && answer.certain && answer.is_shortest &&
          answer.modality() == Modality::certain && answer.unlisted == 0 &&
          answer.unreachable == 0 && leads_in_all(maps, from, to, *answer.certain) &&
          answer.certain->size() == best.at(to).size() &&
          (answer.certain->size() == own || answer.certain == best.at(to)) &&
          shorter_of(answer) == shorter_in(maps, best_of_map, to, answer.certain->size());
      if (!is_right) differing.push_back(std::to_string(from) + " to " + std::to_string(to));
      ++seen.routes;
      if (best.at(to).size() < own) ++seen.shorter_than_trace;
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
    const Trace trace = seeded_walk(seed, 3 + seed % 6).trace;
    INFO(to_keep(seed, trace));
    for (const bool planar : {false, true}) {
      const MapTree tree = tree_of(trace, planar);
      for (const bool only_minimal : {false, true}) check_routes(tree, only_minimal, seen);
    }
  }
  CHECK(seen.routes > 20'000);
  CHECK(seen.shorter_than_trace > 2'000);
  CHECK(seen.shorter_in_some > 2'000);
}
