#include "io/maps_agreement.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace asterism {
namespace {

std::string number_of_maps(std::uint64_t number) {
  return std::to_string(number) + (number == 1 ? " map" : " maps");
}

/// Where nothing cut the run short, all counts are those of the same maps.
void require_complete(const JsonNode& root, const MapReport& report) {
  if (report.consistent && report.per_visit && *report.consistent != report.per_visit->back())
    root["consistent"].refuse(std::to_string(report.per_visit->back()) + ", the last of per_visit");
  if (report.consistent && (*report.consistent > 0) != report.minimal.has_value())
    root["minimal"].refuse(report.minimal ? "null, since no map is consistent"
                                          : "an object, since a map is consistent");
  if (report.per_visit && !report.maps.empty() &&
      report.per_visit->size() != report.maps.front().visits.size())
    root["per_visit"].refuse(
        "an array of " + std::to_string(report.per_visit->size()),
        std::to_string(report.maps.front().visits.size()) + ", one a visit of the maps");
  if (report.options.all && report.consistent && *report.consistent != report.maps.size())
    root["maps"].refuse(number_of_maps(report.maps.size()), std::to_string(*report.consistent));
}

/// What is to be minimised, most important first. Nothing where the maps do not tell it: where a
/// predicate is another than these, or a user's axioms may make fewer paths of a map.
std::optional<std::vector<std::size_t>> extents(const MapOptions& options, std::size_t paths,
                                                std::size_t places) {
  std::vector<std::size_t> result;
  for (const std::string& predicate : options.preference) {
    if (options.axioms != "shipped" || (predicate != "path" && predicate != "place"))
      return std::nullopt;
    result.push_back(predicate == "path" ? paths : places);
  }
  return result;
}

/// The maps listed hold as many minimal models as told, and none below them; or only these.
void require_minimal(const JsonNode& root, const MapReport& report) {
  const auto& [paths, places, count, certified] = *report.minimal;
  if (count == 0) root["minimal"]["count"].refuse("at least 1");
  if (report.maps.size() < count || (!report.options.all && report.maps.size() != count))
    root["maps"].refuse(number_of_maps(report.maps.size()),
                        (report.options.all ? "at least " : "") + std::to_string(count));

  const auto least = extents(report.options, paths, places);
  if (!least) return;
  std::size_t number = 0;
  for (std::size_t i = 0; i < report.maps.size(); ++i) {
    const TopologicalMap& map = report.maps[i];
    const auto these = extents(report.options, map.paths.size(), map.places.size());
    if (these == least) ++number;
    if (these < least || (!report.options.all && these != least))
      root["maps"].items()[i].refuse(
          std::to_string(map.paths.size()) + " paths, " + std::to_string(map.places.size()) +
              " places",
          std::to_string(paths) + " and " + std::to_string(places) + " as in minimal");
  }
  if (number != count)
    root["maps"].refuse(number_of_maps(number) + " as in minimal", std::to_string(count));
}

/// Where no map explains all of the trace, some explain its first visits, and none any more; where
/// a limit ended the run, the visits after are not known of.
void require_unexplained(const JsonNode& root, const MapReport& report) {
  const std::size_t explained = *report.explained_visits;
  const JsonNode node = root["explained"];
  if (explained == 0) node.refuse("at least 1");
  if (report.consistent.value_or(0) > 0 || !report.maps.empty())
    node.refuse("it only where no map explains the trace");
  if (!report.per_visit) return;
  const auto& left = *report.per_visit;
  const auto known = static_cast<std::size_t>(std::ranges::find(left, 0U) - left.begin());
  if (explained != known || (report.complete && known == left.size()))
    node.refuse("the number of visits before per_visit is 0");
}

/// The maps ranked explain what there is to be explained, and are not more than there are.
void require_ranked(const JsonNode& root, const MapReport& report) {
  std::size_t visits = report.ranked.front().map.visits.size();
  std::optional<std::uint64_t> consistent = report.consistent;
  if (report.explained_visits) {
    visits = *report.explained_visits;
    consistent.reset();
    if (report.per_visit) consistent = (*report.per_visit)[visits - 1];
  } else if (!report.maps.empty()) {
    visits = report.maps.front().visits.size();
  } else if (report.complete && report.per_visit) {
    visits = report.per_visit->size();
  }
  if (consistent && report.ranked.size() > *consistent)
    root["ranked"].refuse(number_of_maps(report.ranked.size()),
                          "at most " + std::to_string(*consistent));
  for (std::size_t i = 0; i < report.ranked.size(); ++i)
    if (const std::size_t found = report.ranked[i].map.visits.size(); found != visits)
      root["ranked"].items()[i]["visits"].refuse("an array of " + std::to_string(found),
                                                 std::to_string(visits) + ", one a visit");
}

/// Maps listed are as assumed. Those of a trace not explained may not reach the visits.
void require_assumed(const JsonNode& maps, const TopologicalMap& map, std::size_t number,
                     const MapReport& report) {
  for (const Assumption& assumption : report.options.assumptions) {
    const auto [one, other] = std::minmax({assumption.one.index(), assumption.other.index()});
    if (other < map.visits.size() && !agrees(assumption, map.visits[one], map.visits[other]))
      maps.items()[number]["visits"].refuse("visits " + std::to_string(one) + " and " +
                                                std::to_string(other) + " at places " +
                                                std::to_string(map.visits[one].index()) + " and " +
                                                std::to_string(map.visits[other].index()),
                                            text_of(assumption) + " as assumed");
  }
}

/// A search that was stopped knows the best maps that it met, and none better than it proved.
void require_bounded(const JsonNode& root, const MapReport& report) {
  const JsonNode node = root["bounds"];
  const auto& [at_least, best] = *report.bounds;
  if (report.complete || report.options.method != "search")
    node.refuse("it only where a search did not go to the end");
  if (report.minimal) root["minimal"].refuse("null, as the search did not go to the end");
  if (!best) {
    if (!report.maps.empty()) root["maps"].refuse(number_of_maps(report.maps.size()), "none");
    return;
  }
  if (best->count == 0) node["best"]["count"].refuse("at least 1");
  if (report.maps.empty() || report.maps.size() > best->count)
    root["maps"].refuse(number_of_maps(report.maps.size()), "1 to " + std::to_string(best->count));
  for (std::size_t i = 0; i < report.maps.size(); ++i) {
    const TopologicalMap& map = report.maps[i];
    if (map.paths.size() != best->paths || map.places.size() != best->places)
      root["maps"].items()[i].refuse(
          std::to_string(map.paths.size()) + " paths, " + std::to_string(map.places.size()) +
              " places",
          std::to_string(best->paths) + " and " + std::to_string(best->places) + " as in bounds");
  }
  const std::string& first = report.options.preference.front();
  const std::size_t least = first == "path"    ? best->paths
                            : first == "place" ? best->places
                                               : report.maps.front().segments.size();
  if (least < at_least)
    node[first + "s_at_least"].refuse("at most " + std::to_string(least) + ", as the best map has");
}

}  // namespace

void require_agreement(const JsonNode& root, const MapReport& report) {
  if (report.complete) require_complete(root, report);
  if (report.minimal)
    require_minimal(root, report);
  else if (!report.options.all && !report.bounds && !report.maps.empty())
    root["maps"].refuse(number_of_maps(report.maps.size()), "none, as minimal is null");
  if (report.bounds) require_bounded(root, report);
  if (report.explained_visits) require_unexplained(root, report);
  if (!report.ranked.empty()) require_ranked(root, report);
  for (std::size_t i = 0; i < report.maps.size(); ++i)
    require_assumed(root["maps"], report.maps[i], i, report);
  for (std::size_t i = 0; i < report.ranked.size(); ++i)
    require_assumed(root["ranked"], report.ranked[i].map, i, report);
}

}  // namespace asterism
