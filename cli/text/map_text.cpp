#include "cli/text/map_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "cli/text/query_text.hpp"

namespace asterism {
namespace {

/// "1 map", "2 maps".
std::string counted(std::uint64_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// "view 1", "views 1, 2".
template <class Numbers>
std::string listed(const char* noun, const Numbers& numbers) {
  return fmt::format("{}{} {}", noun, numbers.size() == 1 ? "" : "s", fmt::join(numbers, ", "));
}

std::size_t index_of(const TopologicalMap& map, const TopologicalMap::Place& place) {
  return map.visits[place.first_visit.index()].index();
}

bool has_segment(const TopologicalMap& map, PlaceArm arm) {
  return std::any_of(map.segments.begin(), map.segments.end(), [&](const auto& segment) {
    return segment.first == arm || segment.second == arm;
  });
}

std::string text(const SshMap::Along& along) {
  return fmt::format("path {}{}", along.path.index(), sign_of(along.direction));
}

std::string map_text(const SshMap& map, const Experience& experience) {
  std::string result;
  for (std::size_t d = 0; d < map.places.size(); ++d) {
    std::vector<std::size_t> views;
    for (std::size_t k = 0; k < map.dstates.size(); ++k)
      if (map.dstates[k].index() == d) views.push_back(k);
    result += fmt::format("  dstate {}: {}, \"{}\"; place {}, {}\n", d, listed("view", views),
                          printable(experience.views[views.front()]), map.places[d].index(),
                          text(map.paths[d]));
  }
  for (std::size_t place = 0; place < map.number_of_places(); ++place) {
    std::vector<std::size_t> dstates;
    for (std::size_t d = 0; d < map.places.size(); ++d)
      if (map.places[d].index() == place) dstates.push_back(d);
    result += fmt::format("  place {}: {}\n", place, listed("dstate", dstates));
  }
  for (std::size_t path = 0; path < map.number_of_paths(); ++path) {
    std::set<std::size_t> places;
    for (std::size_t d = 0; d < map.places.size(); ++d)
      if (map.paths[d].path.index() == path) places.insert(map.places[d].index());
    result += fmt::format("  path {}: {}\n", path, listed("place", places));
  }
  const std::size_t robot = map.dstates.back().index();
  return result + fmt::format("  {}; the robot is at place {}, along {}\n",
                              counted(map.segments.size(), "segment"), map.places[robot].index(),
                              text(map.paths[robot]));
}

/// How many maps there are, all and minimal; or what a search knows.
/// @param views  the trace is of these, not of visits
std::string counts_text(const Findings& report, const std::string& planar, bool views) {
  std::string text;
  const bool is_searched = report.options.method == "search" && report.complete;
  if (report.consistent == 0U || (is_searched && !report.minimal)) {
    text +=
        fmt::format("no {}map explains the trace{}", planar,
                    report.options.theory.assumptions.empty() ? "" : " under these assumptions");
    if (report.per_visit && !views)
      text += fmt::format(": none is left after visit {}",
                          std::ranges::find(*report.per_visit, 0U) - report.per_visit->begin());
    else if (report.explained_visits)
      text += fmt::format(": none is left after visit {}", *report.explained_visits);
    text += '\n';
  } else if (report.consistent) {
    text += fmt::format("{} {} the trace\n", counted(*report.consistent, planar + "map"),
                        *report.consistent == 1 ? "explains" : "explain");
  }
  if (report.minimal) text += minimal_text(*report.minimal, report.options);
  for (const auto& [extent, size] : report.own_extents)
    text += fmt::format("  {}: {}\n", extent, size);
  if (report.bounds)
    text += bounds_text(*report.bounds, report.options.theory.preference.front()) + '\n';
  return text;
}

/// Listed in the report, or counted there where it holds the first alone.
std::size_t number_of_maps(const Findings& report, std::size_t listed) {
  if (report.options.all) return report.consistent.value_or(0);
  if (report.minimal) return report.minimal->count;
  return report.bounds && report.bounds->best ? report.bounds->best->count : listed;
}

/// The report but for its maps.
std::string head_text(const Findings& report, std::size_t steps, bool views) {
  const std::string planar = report.options.theory.planar ? "planar " : "";
  const char* const step = views ? "view" : "visit";
  std::string text = fmt::format("{}: {}, {}\n", printable(report.trace), counted(steps, step),
                                 counted(steps - 1, views ? "action" : "travel"));
  text += assuming_text(report.options.theory.assumptions);
  text += method_text(report.options);
  if (report.per_visit)
    text +=
        fmt::format("{}maps after each {}: {}\n", planar, step, fmt::join(*report.per_visit, " "));
  if (!report.complete) {
    text += fmt::format("stopped by {}", report.stopped_by.value_or("a limit"));
    const std::size_t explained = report.per_visit ? report.per_visit->size() : views ? 0 : steps;
    text +=
        explained < steps ? fmt::format(" before {} {} was explained\n", step, explained) : "\n";
  }
  return text + counts_text(report, planar, views);
}

/// @param text_of  a map in words
template <class Report, class TextOf>
std::string report_text(const Report& report, std::size_t steps, std::size_t most_maps, bool views,
                        TextOf text_of) {
  std::string text = head_text(report, steps, views);
  const bool are_minimal = !report.options.all && !report.bounds;
  for (std::size_t i = 0; i < std::min(report.maps.size(), most_maps); ++i)
    text += fmt::format("\n{} {}\n", are_minimal ? "model" : "map", i) + text_of(report.maps[i]);
  const std::size_t all = number_of_maps(report, report.maps.size());
  if (!report.maps.empty() && all > most_maps)
    text += fmt::format("\n({} more: see --json)\n", all - most_maps);
  return text;
}

}  // namespace

std::string bounds_text(const MapReport::Bounds& bounds, std::string_view first_extent) {
  return fmt::format("{}s ≥ {} proved; ", first_extent, bounds.at_least) +
         (bounds.best ? fmt::format("best so far {}, {}, {}", counted(bounds.best->paths, "path"),
                                    counted(bounds.best->places, "place"),
                                    counted(bounds.best->count, "map"))
                      : "no map found so far");
}

std::string minimal_text(const MapReport::Minimal& minimal, const MapOptions& options) {
  const bool is_searched = options.method == "search";
  std::string how = minimal.certified        ? "certified by the solver"
                    : options.certify_s <= 0 ? (is_searched ? "" : "not certified")
                    : options.time_limit_s
                        ? "not certified in the time left"
                        : fmt::format("not certified within {} s", options.certify_s);
  if (is_searched) how = "proved minimal by exhausted search" + (how.empty() ? "" : ", " + how);
  const auto minimised = [&](const char* extent) {
    return std::ranges::find(options.theory.preference, extent) != options.theory.preference.end();
  };
  // What is not minimised may differ from one minimal model to another.
  const bool is_first_alone = minimal.count > 1 && !(minimised("path") && minimised("place"));
  return fmt::format("{}: {}{}, {}; {}\n", counted(minimal.count, "minimal model"),
                     is_first_alone ? "the first has " : "", counted(minimal.paths, "path"),
                     counted(minimal.places, "place"), how);
}

std::string method_text(const MapOptions& options) {
  if (!options.method) return "";
  return options.method == "search" ? "minimal models searched for, maps not listed\n"
                                    : "minimal models chosen from all maps, listed\n";
}

std::string printable(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return (c >= 0 && c < ' ') || c == 127; }, '?');
  return text;
}

std::string map_text(const TopologicalMap& map) {
  std::string text;
  for (const auto& place : map.places) {
    std::vector<std::size_t> visits;
    for (std::size_t k = 0; k < map.visits.size(); ++k)
      if (map.visits[k] == map.visits[place.first_visit.index()]) visits.push_back(k);
    text += fmt::format("  place {}: {}, star {}\n", index_of(map, place), listed("visit", visits),
                        place.star.text());
  }
  for (std::size_t i = 0; i < map.paths.size(); ++i) {
    std::vector<std::size_t> places;
    for (const PlaceId place : map.paths[i].places) places.push_back(place.index());
    text += fmt::format("  path {}: ", i);
    const auto end = [&](std::size_t e) {
      const PlaceArm arm = map.paths[i].ends.at(e);
      return map.places[arm.place.index()].star.has_gateway(arm.arm) ? "..." : "|";
    };
    if (map.paths[i].ends.empty())
      text += fmt::format("({}) closed on itself\n", fmt::join(places, " - "));
    else
      text += fmt::format("{} {} {}\n", end(0), fmt::join(places, " - "), end(1));
  }
  std::size_t open = 0;
  for (std::size_t p = 0; p < map.places.size(); ++p)
    for (std::size_t arm = 0; arm < map.places[p].star.size(); ++arm)
      if (map.places[p].star.has_gateway(arm) && !has_segment(map, {PlaceId(p), arm})) ++open;
  text += fmt::format("  {}, {} not yet travelled; the robot is at place {}\n",
                      counted(map.segments.size(), "segment"), counted(open, "gateway"),
                      map.visits.back().index());
  return text;
}

std::string report_text(const MapReport& report, std::size_t visits, std::size_t most_maps) {
  return report_text(report, visits, most_maps, false,
                     [](const TopologicalMap& map) { return map_text(map); });
}

std::string report_text(const SshReport& report, std::size_t views, std::size_t most_maps) {
  return report_text(report, views, most_maps, true,
                     [&](const SshMap& map) { return map_text(map, report.experience); });
}

}  // namespace asterism
