#include "cli/text/query_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace asterism {

std::string noun(const AnswersReport& report, std::uint64_t count) {
  return fmt::format("{}{}{}", report.options.theory.planar ? "planar " : "",
                     report.only_minimal ? "minimal model" : "map", count == 1 ? "" : "s");
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

std::string assuming_text(std::span<const Assumption> assumptions) {
  return assumptions.empty() ? "" : "assuming " + text_of(assumptions) + '\n';
}

}  // namespace asterism
