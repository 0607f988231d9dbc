#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/driven_way.hpp"
#include "core/grid.hpp"
#include "core/map_report.hpp"
#include "core/ranked_map.hpp"
#include "core/theory_record.hpp"
#include "core/trace.hpp"
#include "core/trajectory.hpp"

namespace asterism {

/// What a run did and found, as one page shows it. Everything but `log` and `trace` may be absent.
struct RunReport {
  /// What became of the candidates by one kind of evidence.
  struct Decision {
    std::string what = {};                    ///< "axioms", "planarity", "preference", ...
    std::string how = {};                     ///< in words
    std::optional<std::uint64_t> count = {};  ///< maps it ruled out or put behind others
  };
  /// A trace that no map explains to its end.
  struct Unexplained {
    std::size_t visits = 0;  ///< explained, from the first
    std::string why = {};    ///< the next one is not
  };
  /// One ranked model and what was drawn of it.
  struct Model {
    RankedMap ranked;                     ///< of the visits explained; a pose for each place
    std::optional<Grid> global_map = {};  ///< in the layout's frame
    Trajectory trajectory = {};
    std::vector<DrivenWay> ways = {};  ///< [segment], or none
    std::string drawing_svg = {};      ///< of the topological map: bare_map_svg(), or empty
  };

  std::string log;  ///< its name
  std::size_t scans = 0;
  double duration_s = 0;
  double driven_m = 0;
  Trace trace;
  std::vector<std::optional<Grid>> place_maps = {};  ///< [visit], in the visit's frame
  std::optional<Grid> odometry_map = {};             ///< the scans drawn where the wheels say

  TheoryRecord theory = {};                          ///< what was asked of every map
  std::vector<std::uint64_t> all_per_visit = {};     ///< hypotheses after visit k
  std::vector<std::uint64_t> planar_per_visit = {};  ///< those that can be drawn in the plane
  std::optional<std::uint64_t> consistent = {};      ///< hypotheses that explain the trace
  std::optional<MapReport::Minimal> minimal = {};
  std::optional<Unexplained> unexplained = {};
  std::vector<Decision> decided = {};
  std::vector<std::string> remarks = {};  ///< what a reader should know, each in a sentence

  std::vector<Model> models = {};  ///< best first
};

}  // namespace asterism
