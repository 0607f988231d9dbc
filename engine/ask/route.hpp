#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/id.hpp"
#include "core/topological_map.hpp"
#include "engine/ask/map_list.hpp"
#include "engine/ask/query.hpp"
#include "engine/ask/turns.hpp"

namespace asterism {

/// A question for a route from where the robot stands at one visit to the place of another. No
/// Claim, since a map makes it neither true nor false.
struct RouteQuery {
  std::string text;
  VisitId from;  ///< as the robot came in; at the first visit by the first arm, if it does not say
  VisitId to;
  std::vector<Query::Mention> mentions;
};

/// What the maps of a trace say to it.
struct RouteAnswer {
  /// A route that some maps have, and that others lack or have lead elsewhere.
  struct InSome {
    Turns route;
    std::uint64_t maps;            ///< that are told by it
    std::vector<Arrival> witness;  ///< the first of them by (visits, entered)
  };

  std::uint64_t of = 0;  ///< maps asked
  /// A route along travels that every map knows, and that ends at the place in every map: the
  /// trace's own way, there or back, unless another is shorter; of the shorter ones the first by
  /// turns.
  std::optional<Turns> certain = {};
  bool is_shortest = true;  ///< no shorter one is certain; false: not found out
  /// The maps that have a shorter one of their own, each told by the first of its shortest, by
  /// turns. Most maps first, then fewest travels.
  std::vector<InSome> shorter = {};
  std::uint64_t unlisted = 0;     ///< maps that have a shorter one, which is not among these
  std::uint64_t unreachable = 0;  ///< maps that know no way: only where axioms are one's own

  Modality modality() const;
};

struct RouteLimits {
  /// Of the search for a certain route: travels tried, each counted in each map that it is tried
  /// in. A second or two.
  std::uint64_t travels = std::uint64_t{1} << 27;
  /// Routes kept to be listed; one found later is not.
  std::size_t routes = std::size_t{1} << 16;
};

/// Asks the maps for routes. Holds few of them at a time: those
/// that refuted a route found so far.
///
/// @param stop  told of the maps looked at
/// @return  nothing if it is to stop
/// @throws  InputError if the query names visits that the trace does not have
std::optional<RouteAnswer> find_route(const MapList& maps, const RouteQuery& query,
                                      const Stop& stop = {}, const RouteLimits& limits = {});
/// Asks all maps of the tree, or its minimal models.
inline std::optional<RouteAnswer> find_route(const MapTree& tree, const RouteQuery& query,
                                             bool only_minimal, const Stop& stop = {},
                                             const RouteLimits& limits = {}) {
  return find_route(only_minimal ? minimal_maps(tree) : all_maps(tree), query, stop, limits);
}

}  // namespace asterism
