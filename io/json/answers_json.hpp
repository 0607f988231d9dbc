#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/map_report.hpp"
#include "engine/ask/query.hpp"
#include "engine/ask/route.hpp"
#include "engine/proof/ask_solver.hpp"

namespace asterism {

/// What the maps of a trace, or its minimal models, say to queries: the content of a file of
/// answers.                                                                   [docs/formats.md]
struct AnswersReport {
  /// The routes asked for, and what was found; without answers, a limit ended the run.
  struct Routes {
    std::vector<RouteQuery> queries = {};
    std::optional<std::vector<RouteAnswer>> answers = {};

    /// Whether of some route it was not found out what it is, or whether it is the shortest.
    bool is_undecided() const;
    bool has_impossible() const;
  };

  std::string trace = {};  ///< its name
  MapOptions options = {};
  bool only_minimal = false;
  std::string by = "enumeration";                ///< or "search" or "solver"
  std::optional<std::uint64_t> consistent = {};  ///< maps that explain the trace, if listed
  std::optional<std::string> stopped_by = {};
  std::vector<Query> queries = {};
  std::optional<std::vector<Answer>> answers = {};  ///< nothing: a limit ended the run
  std::vector<SolverAnswer> solved = {};            ///< where the solver was asked instead
  Routes routes = {};

  /// Whether each query is answered.
  bool is_complete() const;
};

/// The file's content, a query and a route a line.
std::string answers_json(const AnswersReport& report);

/// Maps that are told by no certain route, as far as it is listed or not.
std::uint64_t maps_with_shorter(const RouteAnswer& answer);

/// "certain", "possible", "impossible" or, where too many routes were tried, "undecided".
const char* verdict_of(const RouteAnswer& answer);

}  // namespace asterism
