#pragma once

#include <map>
#include <utility>
#include <vector>

#include "core/topological_map.hpp"
#include "engine/ask/route.hpp"

namespace asterism {

// Routes told a second way, from maps written out: by trying, and forgetting nothing that was
// tried.

/// A map written out, with the travels made in it.
struct Walked {
  explicit Walked(TopologicalMap written);
  TopologicalMap map;
  std::vector<std::pair<PlaceArm, PlaceArm>> travels;
};

/// Whether the route can be gone in all of these maps, and ends at the place of the visit.
bool leads_in_all(const std::vector<Walked>& maps, std::size_t from, std::size_t to,
                  const Turns& route);

/// To each visit the route that has the fewest travels, and of those is the first by turns, among
/// all that can be gone in all of these maps and end at its place in all. Tries every row of turns,
/// up to so many travels: some 3^travels.
std::map<std::size_t, Turns> best_in_all(const std::vector<Walked>& maps, std::size_t from,
                                         std::size_t most_travels);

/// The same in one map, of any number of travels.
std::map<std::size_t, Turns> best_in(const Walked& walked, std::size_t from);

}  // namespace asterism
