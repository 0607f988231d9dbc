#include "io/json/maps_agreement.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "core/extents.hpp"

namespace asterism {
namespace {

std::string number_of_maps(std::uint64_t number) {
  return std::to_string(number) + (number == 1 ? " map" : " maps");
}

struct Size {
  std::size_t paths, places;
  friend bool operator==(const Size&, const Size&) = default;
};

Size size_of(const TopologicalMap& map) { return {map.paths.size(), map.places.size()}; }
Size size_of(const SshMap& map) { return {map.number_of_paths(), map.number_of_places()}; }

[[noreturn]] void refuse_size(const JsonNode& root, std::size_t map, Size found, Size expected,
                              const std::string& as_in) {
  root["maps"].items()[map].refuse(
      std::to_string(found.paths) + " paths, " + std::to_string(found.places) + " places",
      std::to_string(expected.paths) + " and " + std::to_string(expected.places) + as_in);
}

/// All counts are those of the same maps.
/// @param key   that of the counts after each step
/// @param maps  how many are listed
void require_counts(const JsonNode& root, const Findings& found, const std::string& key,
                    std::size_t maps) {
  if (found.consistent && found.per_visit && *found.consistent != found.per_visit->back())
    root["consistent"].refuse(std::to_string(found.per_visit->back()) + ", the last of " + key);
  if (!found.complete || !found.consistent) return;
  if ((*found.consistent > 0) != found.minimal.has_value())
    root["minimal"].refuse(found.minimal ? "null, since no map is consistent"
                                         : "an object, since a map is consistent");
  if (found.options.all && *found.consistent != maps)
    root["maps"].refuse(number_of_maps(maps), std::to_string(*found.consistent));
}

/// What is to be minimised, most important first. Nothing where an extent is another than these:
/// the maps do not tell it.
std::optional<std::vector<std::size_t>> extents(const MapOptions& options, Size size) {
  std::vector<std::size_t> result;
  for (const std::string& name : options.theory.preference) {
    const auto extent = extent_named(name);
    if (extent != Extent::path && extent != Extent::place) return std::nullopt;
    result.push_back(extent == Extent::path ? size.paths : size.places);
  }
  return result;
}

/// The maps listed hold as many minimal models as told, and none below them; or only these.
/// @param tell_extents  what is minimised of the maps follows from them
template <class Report>
void require_minimal(const JsonNode& root, const Report& report, bool tell_extents) {
  if (!report.minimal) {
    if (!report.options.all && !report.maps.empty())
      root["maps"].refuse(number_of_maps(report.maps.size()), "none, as minimal is null");
    return;
  }
  const auto& [paths, places, count, certified] = *report.minimal;
  if (count == 0) root["minimal"]["count"].refuse("at least 1");
  if (report.maps.size() < count || (!report.options.all && report.maps.size() != count))
    root["maps"].refuse(number_of_maps(report.maps.size()),
                        (report.options.all ? "at least " : "") + std::to_string(count));

  const auto least = extents(report.options, {paths, places});
  if (!least || !tell_extents) return;
  std::size_t number = 0;
  for (std::size_t i = 0; i < report.maps.size(); ++i) {
    const Size size = size_of(report.maps[i]);
    const auto these = extents(report.options, size);
    if (these == least) ++number;
    if (these < least || (!report.options.all && these != least))
      refuse_size(root, i, size, {paths, places}, " as in minimal");
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

/// The maps ranked explain what there is to be explained, and are not more than there are. In
/// pieces they are of a trace that no map explains whole, and all cut alike.
void require_ranked(const JsonNode& root, const MapReport& report) {
  const TopologicalMap& first = report.ranked.front().map;
  std::size_t visits = first.visits.size();
  std::optional<std::uint64_t> consistent = report.consistent;
  const auto cut = pieces_of(first);
  for (std::size_t i = 0; i < report.ranked.size(); ++i)
    if (pieces_of(report.ranked[i].map) != cut)
      root["ranked"].items()[i]["left"].refuse("null at other visits than in the first map",
                                               "all maps cut alike");
  if (cut.size() > 1) {
    if (!report.explained_visits || !report.complete)
      root["ranked"].items()[0]["left"].refuse("null before the last visit",
                                               "it only where no map explains the trace");
    consistent.reset();
    if (report.per_visit) visits = report.per_visit->size();
  } else if (report.explained_visits) {
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
  for (const Assumption& assumption : report.options.theory.assumptions) {
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
    const Size size = size_of(report.maps[i]);
    const Size expected{best->paths, best->places};
    if (size != expected) refuse_size(root, i, size, expected, " as in bounds");
  }
  const std::string& first = report.options.theory.preference.front();
  const auto extent = extent_named(first);
  const std::size_t least = extent == Extent::path    ? best->paths
                            : extent == Extent::place ? best->places
                                                      : report.maps.front().segments.size();
  if (least < at_least)
    node[first + "s_at_least"].refuse("at most " + std::to_string(least) + ", as the best map has");
}

}  // namespace

void require_agreement(const JsonNode& root, const MapReport& report) {
  require_counts(root, report, "per_visit", report.maps.size());
  if (report.complete && report.per_visit && !report.maps.empty() &&
      report.per_visit->size() != report.maps.front().visits.size())
    root["per_visit"].refuse(
        "an array of " + std::to_string(report.per_visit->size()),
        std::to_string(report.maps.front().visits.size()) + ", one a visit of the maps");
  // A user's axioms may make fewer paths of a map.
  if (report.minimal || !report.bounds)
    require_minimal(root, report, report.options.theory.axioms == "shipped");
  if (report.bounds) require_bounded(root, report);
  if (report.explained_visits) require_unexplained(root, report);
  if (!report.ranked.empty()) require_ranked(root, report);
  for (std::size_t i = 0; i < report.maps.size(); ++i)
    require_assumed(root["maps"], report.maps[i], i, report);
  for (std::size_t i = 0; i < report.ranked.size(); ++i)
    require_assumed(root["ranked"], report.ranked[i].map, i, report);
}

void require_agreement(const JsonNode& root, const SshReport& report) {
  const std::size_t views = report.experience.views.size();
  if (report.per_visit && (report.complete || report.consistent ? report.per_visit->size() != views
                                                                : report.per_visit->size() > views))
    root["per_view"].refuse("an array of " + std::to_string(report.per_visit->size()),
                            std::to_string(views) + ", one a view");
  require_counts(root, report, "per_view", report.maps.size());
  require_minimal(root, report, true);
}

}  // namespace asterism
