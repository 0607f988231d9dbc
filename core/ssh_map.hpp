#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "core/experience.hpp"
#include "core/id.hpp"

namespace asterism {

using DStateId = Id<struct DStateTag>;  ///< dstates of a map, by first view

/// One explanation of an experience of the basic SSH, written out.      [BMK10, §3.3] [theory §5]
///
/// Places and paths are the least that the axioms force: a place is the dstates that turns join, a
/// path those that travels and turn-arounds join, whichever way they face.
struct SshMap {
  /// Which way a dstate faces along its path. The first dstate of a path faces forward. Where a
  /// dstate turns out to face both ways, no axiom tells the directions of its path apart.
  enum class Direction { forward, backward, both };
  /// Where a dstate is on the paths: on which, and facing which way.
  struct Along {
    PathId path;
    Direction direction;
    friend bool operator==(const Along&, const Along&) = default;
  };
  using Segment = std::pair<DStateId, DStateId>;  ///< a travel leads from the first to the second

  std::vector<DStateId> dstates;  ///< of each view
  std::vector<PlaceId> places;    ///< of each dstate, numbered by first dstate
  std::vector<Along> paths;       ///< of each dstate, numbered likewise
  std::vector<Segment> segments;  ///< each once, as first travelled, a known way back with it

  /// How many places the dstates are at.
  std::size_t number_of_places() const;
  /// How many paths the dstates face along.
  std::size_t number_of_paths() const;

  friend bool operator==(const SshMap&, const SshMap&) = default;
};

/// "+", "-", or "+-" for both.
std::string_view sign_of(SshMap::Direction direction);

/// Writes out what follows if these views were seen at these dstates. Explains the first
/// dstates.size() views. Asks no axiom: what contradicts them is written out all the same.
///
/// @pre  dstates are numbered by first view: each is at most one more than the largest before it
/// @throws std::invalid_argument otherwise
SshMap make_ssh_map(const Experience& experience, std::span<const DStateId> dstates);

}  // namespace asterism
