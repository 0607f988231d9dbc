#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "core/topological_map.hpp"
#include "engine/explanation.hpp"
#include "engine/query.hpp"

namespace asterism {

// What answers to all kinds of queries, and explanations, are made of.

inline const char* name_of(Modality modality) {
  switch (modality) {
    case Modality::certain:
      return "certain";
    case Modality::possible:
      return "possible";
    case Modality::impossible:
      break;
  }
  return "impossible";
}

/// "planar map", or "planar maps" if it is not one.
std::string noun(const QueryCommand& command, std::uint64_t count);

/// As it may be shown in one line: what is read has no control characters but white space.
std::string one_line(std::string query);

/// "0 1 2 0": the place of each visit.
std::string visits_text(const std::vector<Arrival>& arrivals);

/// A map as JSON tells it: an object of "visits" and "entered", or null without a map.
std::string map_json(const std::optional<std::vector<Arrival>>& map);

/// A map of all visits.
std::vector<Arrival> whole(const PartialMap& map);

}  // namespace asterism
