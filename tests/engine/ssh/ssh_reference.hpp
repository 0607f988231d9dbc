#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "axioms/fact.hpp"
#include "core/experience.hpp"

namespace asterism {

// Plain ways to get what the engine says of the basic SSH, to judge it by.

/// The dstate of each view, numbered by first view.
using Naming = std::vector<std::size_t>;

/// What was seen and done, if these were the dstates.
std::vector<Fact> plain_facts(const Experience& experience, const Naming& naming);

/// Every partition of so many views, sorted.
std::vector<Naming> every_partition(std::size_t views);

/// Every partition of the views whose facts plain forward chaining does not refute, sorted.
std::vector<Naming> every_ssh_map(const Experience& experience);

/// Paths and places, by telling dstates that are joined the least number until nothing changes.
std::pair<std::size_t, std::size_t> plain_extents(const Experience& experience,
                                                  const Naming& naming);

/// Whether some circular order of segments round each place gives V - E + F = 2, part by part.
/// Tries all: for places of few segments.
bool has_plane_embedding(std::size_t vertices,
                         const std::vector<std::pair<std::size_t, std::size_t>>& edges);
/// The same for places and travels of a map.
bool has_plane_embedding(const Experience& experience, const Naming& naming);

/// "v0 travel v1 turn:right v0".
Experience experience(const std::string& text);

/// A tour of places that are told by what is seen in their middle, and nothing else by anything:
/// "place, travel to the next, turn to the middle" again and again.
Experience tour(const std::vector<std::size_t>& places);

/// The dstates of views if those that look alike are one.
Naming of_few_dstates(const Experience& experience);

/// Of random symbols, or of a walk through a random world, some views of which are alike.
Experience seeded_experience(unsigned seed, std::size_t views);

}  // namespace asterism
