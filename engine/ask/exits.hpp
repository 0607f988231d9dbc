#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/star.hpp"
#include "engine/ask/map_list.hpp"
#include "engine/ask/turns.hpp"

namespace asterism {

/// What a robot may see where a travel ends, and how many maps would then explain the trace.
struct Outlook {
  /// The star as seen from the arm come in by, see star_as_seen; absent: anything that no map
  /// expects, at a place that would be new.
  std::optional<Star> seen;
  std::uint64_t left = 0;
  /// Of seeing it, if the maps are equally likely, in each map the ways to go on are, and a new
  /// place looks like one of the visits so far or like none, each alike, and is come to by any of
  /// its gateways.
  double chance = 0;
};

/// A way to go on from the last visit: all travels but the last lead along segments that every map
/// has, to what all expect to look the same.                       [BMK10, §10.2] docs/next.md
struct Exit {
  Turns turns;
  std::uint64_t known = 0;        ///< maps in which the last travel is along a segment
  std::uint64_t open = 0;         ///< maps in which it may end anywhere that the axioms allow
  std::vector<Outlook> outlooks;  ///< likely ones first
  double expected_left = 0;       ///< maps, over the outlooks; to six decimals
  bool tells = true;              ///< whether it can change anything
};

struct ExitBounds {
  std::size_t travels = 3;   ///< of an exit
  std::size_t places = 100;  ///< to look out from
};

struct Exits {
  std::vector<Exit> exits;  ///< that with the fewest maps expected first; what tells nothing last
  bool complete = true;     ///< whether there is no more exit beyond the bounds
};

/// The exits that a robot can go to now, if one of these maps is right. Those that tell nothing are
/// listed only where they are one travel away. Holds no map, and goes once through them for each
/// travel.
///
/// @param stop  told of the maps looked at in this turn
/// @return  nothing if it is to stop
/// @pre     there is a map, and nothing was assumed
/// @throws  std::invalid_argument if the axioms are none that the native engine knows
std::optional<Exits> exits(const MapList& maps, const ExitBounds& bounds = {},
                           const Stop& stop = {});
/// Of all maps of a tree.
inline std::optional<Exits> exits(const MapTree& tree, const ExitBounds& bounds = {},
                                  const Stop& stop = {}) {
  return exits(all_maps(tree), bounds, stop);
}

}  // namespace asterism
