#include "cli/query_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace asterism {

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

std::vector<Arrival> whole(const PartialMap& map) {
  std::vector<Arrival> result;
  for (const std::optional<Arrival>& arrival : map) result.push_back(arrival.value());
  return result;
}

}  // namespace asterism
