#include "tests/engine/ask/route_reference.hpp"

#include <algorithm>
#include <optional>
#include <set>

namespace asterism {
namespace {

/// The robot at a place, in by an arm of its star.
using Position = PlaceArm;

Position position_at(const Walked& walked, std::size_t visit) {
  return {walked.map.visits[visit], walked.map.entered[visit].value_or(0)};
}

std::size_t turns_at(const Walked& walked, Position at) {
  return walked.map.places[at.place.index()].star.size();
}

/// Where one turn and travel lead, as the first travel there or back showed.
std::optional<Position> step(const Walked& walked, Position at, std::size_t turn) {
  if (turn >= turns_at(walked, at)) return std::nullopt;
  const PlaceArm left{at.place, (at.arm + turn) % turns_at(walked, at)};
  for (const auto& [one, other] : walked.travels) {
    if (one == left) return other;
    if (other == left) return one;
  }
  return std::nullopt;
}

std::optional<PlaceId> walk(const Walked& map, std::size_t from, const Turns& route) {
  Position at = position_at(map, from);
  for (const std::size_t turn : route) {
    const auto next = step(map, at, turn);
    if (!next) return std::nullopt;
    at = *next;
  }
  return at.place;
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
void try_all(const std::vector<Walked>& maps, const std::vector<Position>& at,
             std::size_t most_travels, Turns& route, std::map<std::size_t, Turns>& best) {
  for (std::size_t to = 0; to < maps.front().map.visits.size(); ++to) {
    bool is_there = true;
    for (std::size_t m = 0; is_there && m < maps.size(); ++m)
      is_there = at[m].place == maps[m].map.visits[to];
    if (is_there) keep_better(best, to, route);
  }
  if (route.size() == most_travels) return;
  for (std::size_t turn = 0; turn < turns_at(maps.front(), at.front()); ++turn) {
    std::vector<Position> next;
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

}  // namespace

Walked::Walked(TopologicalMap written) : map(std::move(written)) {
  for (std::size_t k = 1; k < map.visits.size(); ++k)
    travels.emplace_back(PlaceArm{map.visits[k - 1], map.left[k - 1].value()},
                         PlaceArm{map.visits[k], map.entered[k].value()});
}

bool leads_in_all(const std::vector<Walked>& maps, std::size_t from, std::size_t to,
                  const Turns& route) {
  return std::ranges::all_of(
      maps, [&](const Walked& map) { return walk(map, from, route) == map.map.visits[to]; });
}

std::map<std::size_t, Turns> best_in_all(const std::vector<Walked>& maps, std::size_t from,
                                         std::size_t most_travels) {
  std::map<std::size_t, Turns> best;
  std::vector<Position> at;
  for (const Walked& map : maps) at.push_back(position_at(map, from));
  Turns route;
  try_all(maps, at, most_travels, route, best);
  return best;
}

std::map<std::size_t, Turns> best_in(const Walked& map, std::size_t from) {
  // Level by level; all that come to a place by one arm are compared before going on.
  std::map<std::size_t, Turns> best;
  std::set<PlaceId> seen;
  std::map<Position, Turns> level{{position_at(map, from), {}}};
  while (!level.empty()) {
    std::map<Position, Turns> next;
    for (const auto& [at, route] : level) {
      for (std::size_t to = 0; to < map.map.visits.size(); ++to)
        if (map.map.visits[to] == at.place) keep_better(best, to, route);
      if (seen.contains(at.place)) continue;
      for (std::size_t turn = 0; turn < turns_at(map, at); ++turn) {
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

}  // namespace asterism
