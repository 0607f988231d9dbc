#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/map_report.hpp"
#include "core/trace.hpp"
#include "engine/ask/exits.hpp"
#include "engine/ask/telling_apart.hpp"

namespace asterism {

/// The ways on from where a trace ends, and what each may tell: the content of a file of exits.
///                                                                           [docs/formats.md]
struct ExitsReport {
  std::string trace;  ///< its name
  Visit last;         ///< of the trace
  MapOptions options;
  std::size_t max_travels = 0;  ///< of an exit
  bool only_minimal = false;    ///< the minimal models alone were asked
  std::optional<std::string> stopped_by = {};
  std::optional<std::uint64_t> consistent = {};  ///< maps that explain the trace, if listed
  std::optional<std::uint64_t> minimal = {};     ///< minimal models, if found
  /// Nothing where no map explains the trace, or a limit ended the run.
  std::optional<Exits> exits = {};
  TellingApart apart = {};
};

/// The file's content, an exit a line.
std::string exits_json(const ExitsReport& report);

}  // namespace asterism
