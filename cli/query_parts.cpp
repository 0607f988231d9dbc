#include "cli/query_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace asterism {

using Json = nlohmann::ordered_json;

std::string noun(const QueryCommand& command, std::uint64_t count) {
  return fmt::format("{}{}{}", command.map.options.planar ? "planar " : "",
                     command.only_minimal ? "minimal model" : "map", count == 1 ? "" : "s");
}

std::string one_line(std::string query) {
  std::ranges::replace_if(
      query, [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
  return query;
}

std::string visits_text(const std::vector<Arrival>& arrivals) {
  std::vector<std::size_t> places;
  for (const Arrival& arrival : arrivals) places.push_back(arrival.place.index());
  return fmt::format("{}", fmt::join(places, " "));
}

std::string map_json(const std::optional<std::vector<Arrival>>& map) {
  if (!map) return "null";
  Json visits = Json::array();
  Json entered = Json::array();
  for (const Arrival& arrival : *map) {
    visits.push_back(arrival.place.index());
    entered.push_back(arrival.entered ? Json(*arrival.entered) : Json());
  }
  return Json{{"visits", visits}, {"entered", entered}}.dump();
}

std::vector<Arrival> whole(const PartialMap& map) {
  std::vector<Arrival> result;
  for (const std::optional<Arrival>& arrival : map) result.push_back(arrival.value());
  return result;
}

}  // namespace asterism
