#pragma once

#include <cstddef>
#include <vector>

#include "engine/ask/exits.hpp"

namespace asterism {

/// Numbers that the search for it may hold at once: one for each model in each of its states.
inline constexpr std::size_t default_most_numbers = 5'000'000;

/// How to tell minimal models apart by going on.
struct TellingApart {
  enum class Answer {
    found,
    none,           ///< no row of travels tells them all apart
    out_of_bounds,  ///< none was found, the bound reached
    stopped
  };
  Answer answer = Answer::none;
  Turns turns;  ///< the shortest, and of these the first; one model needs none
  /// What each model expects to see after each travel, up to where no other expects the same.
  /// Models are in the order of reports, by (visits, entered).                       [theory §9]
  std::vector<std::vector<Star>> expected;
};

/// The shortest row of travels after which no two of these models expect to have seen the same. A
/// model expects something for sure only along its segments: a travel out of a gateway that is open
/// in a model tells it apart from no other, unless that was done before.
///
/// @throws std::invalid_argument if the axioms are none that the native engine knows
TellingApart tell_apart(const MapList& models, std::size_t most_numbers = default_most_numbers,
                        const Stop& stop = {});
/// Of the minimal models of a tree.
inline TellingApart tell_apart(const MapTree& tree, std::size_t most_numbers = default_most_numbers,
                               const Stop& stop = {}) {
  return tell_apart(minimal_maps(tree), most_numbers, stop);
}

}  // namespace asterism
