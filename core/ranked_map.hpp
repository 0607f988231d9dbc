#pragma once

#include <cstddef>
#include <vector>

#include "core/layout.hpp"
#include "core/topological_map.hpp"

namespace asterism {

/// How far off measures are, and how often chance alone would be as far.
struct Misfit {
  double chi_squared = 0;
  std::size_t degrees_of_freedom = 0;  ///< 0: nothing to disagree; then the tail is 1
  double tail_probability = 1;         ///< of chi_squared or more
};

/// L_i: where one visit was in the frame of the place it returned to.  [BMK10, §7.3.1] [theory §12]
struct Alignment {
  VisitId visit;
  PlaceId place;
  Pose2 place_from_visit = {};
  PoseCovariance covariance = {};
  Misfit misfit = {};        ///< of corresponding gateways
  double matched_walls = 0;  ///< share of the walls of either place map that the other has too
};

/// Two places of one floor that cannot both be where they are laid out.             [theory §12]
struct SharedSpot {
  PlaceId one;
  PlaceId other;
  double distance_m = 0;  ///< of the middles of their gateways
  Misfit misfit = {};     ///< of their lying apart: the least that their layout would be off then
};

/// A map hypothesis with its layout, as ranked.                                   [theory §12]
struct RankedMap {
  TopologicalMap map;
  Layout layout = {};
  std::vector<PlaceDisplacement> displacements = {};  ///< one a travel
  std::vector<Alignment> alignments = {};             ///< one a return to a place, by visit
  Misfit misfit = {};                                 ///< of the layout
  double log_likelihood = 0;  ///< of the displacements and alignments, given the layout
  std::vector<SharedSpot> shared_spots = {};  ///< of its places, two by two
  bool is_plausible = true;  ///< the layout and each alignment, and no two places share a spot
};

}  // namespace asterism
