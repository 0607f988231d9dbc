#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/id.hpp"
#include "core/map_drawing.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"

namespace asterism {

/// What a picture of a clash shows: premises that cannot all be, none of which can be spared.
struct ClashPicture {
  /// What a claim or an assumption says of two visits.
  struct Claimed {
    VisitId one, other;
    bool are_same = true;  ///< at one place; else at two
  };
  struct Line {
    std::string name;  ///< "view"
    std::string words;
  };
  /// The map that there would be, were it not for planarity.
  struct Crossing {
    /// Places, and segments: last the one that cannot be drawn, so that its drawing leads that one
    /// over others. What else is in it is not shown.
    TopologicalMap map;
    MapDrawing drawing;
    VisitId visit;                                         ///< where the last segment's travel ends
    std::vector<std::pair<VisitId, PlaceId>> visits = {};  ///< where those told of are
    std::vector<PlaceId> names = {};  ///< place p is shown as names[p]; as p if there are none
    std::vector<std::vector<PlaceId>> loops = {};  ///< closed ways to cross: places, in order
  };

  std::string title = {};             ///< "same(8, 10): impossible"
  std::vector<VisitId> visits = {};   ///< that take part
  std::vector<Claimed> claimed = {};  ///< if of a visit that takes no part, it is shown dashed
  std::vector<Line> said = {};        ///< a premise a line, other than visits
  std::vector<Line> without = {};     ///< a premise a line, and what the others allow
  std::optional<Crossing> crossing = {};
};

/// A picture of a clash: the visits in a row, each with the star seen, the arm entered by to the
/// left; then the map that would cross itself, if that matters; then the premises in words. A
/// standalone SVG 1.1.
///
/// Travels are dark lines from visit to visit, claims red ones above them.
///
/// @pre  the visits are the trace's, the places the map's, which has a segment
std::string clash_svg(const Trace& trace, const ClashPicture& picture);

}  // namespace asterism
