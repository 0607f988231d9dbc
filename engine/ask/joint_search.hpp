#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/ask/route_map.hpp"

namespace asterism {

/// Searches for a route that leads from one visit to the place of another in several maps at once.
class JointSearch {
 public:
  /// @param travels  that may be tried in all searches together, each counted in each map
  JointSearch(VisitId from, VisitId to, std::uint64_t travels)
      : from_(from), to_(to), travels_left_(travels) {}

  void add(const RouteMap& map);

  /// Of the shortest routes that are certain in all maps added, the first by turns; nothing if
  /// there is none of so few travels, or gave_up().
  std::optional<Turns> shortest(std::size_t most_travels);
  /// Travels or room ran out: what there is, is not known.
  bool gave_up() const { return gave_up_; }

 private:
  /// A way the search has come, as far as it is not in `positions_`.
  struct Reached {
    std::size_t before;  ///< number of the one it goes on from
    std::size_t turn;
    std::size_t travels;
  };

  std::span<const ArmId> positions(std::size_t reached) const {
    return std::span(positions_).subspan(reached * maps_.size(), maps_.size());
  }
  bool is_goal(std::size_t reached) const;
  bool go_on(std::size_t reached, std::size_t turn, std::size_t most_travels);

  VisitId from_;
  VisitId to_;
  std::uint64_t travels_left_;
  bool gave_up_ = false;
  std::vector<RouteMap> maps_;
  std::vector<IdVector<VisitId, std::size_t>> travels_to_goal_;  ///< of each map, from each place
  std::vector<Reached> reached_;
  std::vector<ArmId> positions_;  ///< one a map, for each of these
};

}  // namespace asterism
