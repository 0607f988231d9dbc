#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/grid.hpp"
#include "core/ranked_map.hpp"
#include "core/trace.hpp"
#include "metric/place_walls.hpp"

namespace asterism {

/// How well gateways and walls tell where a visit was.
struct AlignmentOptions {
  double radius_m = 12;  ///< walls farther from where a visit was entered do not count

  // Deviations of a gateway seen at two visits: at corners, where they are least certain.
  double aside_m = 0.3;  ///< of its middle, across the way
  double ahead_m = 1.5;  ///< of its middle, along the way: where a corridor narrows is hard to say
  double heading_rad = 0.15;

  // Deviations that all walls seen at two visits share.
  double shared_m = 0.015;
  double shared_rad = 0.0025;
};

/// L_i for a hypothesis' returns: where a visit was in the frame of the place's first.
///                                                           [BMK10, §7.3.1] [theory §12]
/// Never searched blindly: it begins with the gateways that the hypothesis says are the same, and
/// is refined on the walls of both place maps. Each asked for is worked out once.
/// For one thread at a time: it keeps what it has worked out.
class PlaceAlignments {
 public:
  /// @param trace       must outlive this
  /// @param place_maps  of each visit in its frame, as far as there are any
  PlaceAlignments(const Trace& trace, std::vector<std::optional<Grid>> place_maps,
                  const AlignmentOptions& options = {});

  /// Where a visit was in the frame of the first visit to its place.           [BMK10, §7.3.1]
  ///
  ///   place_from_visit = argmin_L Σ_g ‖(g_first ⊖ L·g_visit) / σ‖² + Σ_w ρ(nᵀ(L·p - q))²
  ///
  /// over the gateways g that the hypothesis says are one, and the bits of wall w that both maps
  /// show. Its covariance is the inverse of the curvature there, in the visit's frame.
  ///
  /// @param entered  the arm of the first visit's star by which the later one was entered, by the
  ///                 hypothesis
  /// @return its `place` is the first visit's number: only the caller knows the map
  /// @pre    the two visits' stars have as many arms
  const Alignment& operator()(VisitId first, VisitId visit, std::size_t entered);

 private:
  struct GatewayPair {
    MeasuredGateway first;
    MeasuredGateway second;
  };

  std::vector<GatewayPair> pairs(VisitId first, VisitId visit, std::size_t entered) const;
  Alignment align(const std::vector<GatewayPair>& pairs, VisitId first, VisitId visit);
  const PlaceWalls* walls(VisitId visit);

  const Trace& trace_;
  std::vector<std::optional<Grid>> place_maps_;
  AlignmentOptions options_;
  std::vector<std::optional<PlaceWalls>> walls_;
  std::map<std::array<std::size_t, 3>, Alignment> known_;
};

}  // namespace asterism
