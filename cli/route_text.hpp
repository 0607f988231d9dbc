#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "core/trace.hpp"
#include "engine/map_list.hpp"
#include "engine/route.hpp"

namespace asterism {

/// The routes asked for, and what was found; without answers, a limit ended the run.
struct RouteReport {
  std::vector<RouteQuery> queries;
  std::optional<std::vector<RouteAnswer>> answers = {};

  /// Whether of some route it was not found out what it is, or whether it is the shortest.
  bool is_undecided() const;
  bool has_impossible() const;
};

/// @return  false if go_on said to stop
bool find_routes(const MapList& maps, const std::function<bool(std::uint64_t maps)>& go_on,
                 RouteReport& report);

/// Prints them in words on stdout.
void print_routes(const QueryCommand& command, const Trace& trace, const RouteReport& report,
                  const std::optional<std::string>& stopped_by);

/// The part of a JSON file that tells them: the key "routes", a route a line.
void write_routes(std::ostream& out, const RouteReport& report);

}  // namespace asterism
