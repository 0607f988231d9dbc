#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axioms/theory.hpp"
#include "core/grid.hpp"
#include "core/map_report.hpp"
#include "core/ranked_map.hpp"
#include "engine/ask/query_reader.hpp"
#include "io/log/carmen_log.hpp"
#include "mapping/drawn_model.hpp"
#include "mapping/explained_trace.hpp"
#include "mapping/kept_perception.hpp"
#include "mapping/perceived.hpp"
#include "mapping/trace_maps.hpp"
#include "metric/ranking.hpp"
#include "perception/scan_detector.hpp"

namespace asterism {

/// What is asked of a log.
struct LogQuestion {
  LogOptions laser = {};
  ScanDetectorOptions detector = {};
  /// Results of an earlier run, whose perception is taken up if it was of this log and alike.
  std::optional<std::filesystem::path> results_before = {};
  std::optional<ToldTrace> told = {};              ///< in place of what is perceived
  std::vector<StatedAssumption> assumptions = {};  ///< that maps hold
  MapOptions maps = {};                            ///< of `theory`, only whether they are planar
  bool only_minimal = false;                       ///< only the minimal models are ranked
  RankingOptions ranking = {};                     ///< which are drawn, too
  double resolution_m = 0.05;                      ///< of the global maps; large ones are coarser
};

/// All that a log says.
struct LogMaps {
  Perceived perceived;
  ExplainedTrace explained;  ///< its report holds the ranked maps, best first
  std::vector<DrawnModel> models = {};
  std::optional<Grid> odometry_map = {};  ///< the scans drawn where the wheels say
  /// What a reader of these should know, each in a sentence: of the log, and of what was not drawn
  /// as was asked.
  std::vector<std::string> remarks = {};
};

/// Watches a log being mapped: is told of each stage that is over.
struct LogWatch {
  ReadWatch read = [](const LogReader&, const Perceived&) {};  ///< while the log is read
  MapWatch maps = {};                                          ///< while maps are looked for
  /// The log is read, and its places found.
  std::function<void(const Perceived&)> perceived = [](const Perceived&) {};
  /// The maps are found.
  std::function<void(const ExplainedTrace&)> explained = [](const ExplainedTrace&) {};
  /// They are ranked; what is left is to draw them.
  std::function<void(const ExplainedTrace&)> ranked = [](const ExplainedTrace&) {};
};

/// From a laser log to ranked maps, each with its layout, its trajectory and its global map.
///                                                                          [BMK10] [theory §11,
///                                                                          §12]
/// @throws InputError if the log cannot be read, no place is found in it, or what is assumed names
///         visits that are not there
LogMaps map_log(const std::string& file, const LogQuestion& asked = {}, const LogWatch& watch = {});

/// The best maps of a trace by layout and preference, then its minimal models, however ill they
/// fit.                                                                   [BMK10, §7] [theory §12]
/// @param place_maps  of each visit in its frame, as far as there are any
std::vector<RankedMap> rank(const TraceMaps& maps,
                            const std::vector<std::optional<Grid>>& place_maps,
                            const RankingOptions& options = {});

/// Maps of a trace that is cut into parts, each in as many pieces: first the best of each part,
/// then the second best of each, and so on; the last again where a part has no more. They are laid
/// out in one frame, by what was travelled between the parts. A place that is in two parts is two
/// here, so that a map in pieces is seldom plausible.
/// @param parts  the maps of each, in order
/// @pre   each has a map
std::vector<RankedMap> rank_in_pieces(const Trace& trace, std::span<const TraceMaps> parts,
                                      const std::vector<std::optional<Grid>>& place_maps,
                                      const RankingOptions& options = {});

}  // namespace asterism
