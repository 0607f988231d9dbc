#include "cli/map_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/map_parts.hpp"

namespace asterism {
namespace {

/// "1 map", "2 maps".
std::string counted(std::uint64_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string list(const std::vector<std::size_t>& numbers) {
  return fmt::format("{}", fmt::join(numbers, ", "));
}

std::string arm_text(const TopologicalMap& map, PlaceArm arm) {
  const Star& star = map.places[arm.place.index()].star;
  return fmt::format("place {} arm {}", arm.place.index(), star.name(arm.arm));
}

std::size_t index_of(const TopologicalMap& map, const TopologicalMap::Place& place) {
  return map.visits[place.first_visit.index()].index();
}

bool has_segment(const TopologicalMap& map, PlaceArm arm) {
  return std::any_of(map.segments.begin(), map.segments.end(), [&](const auto& segment) {
    return segment.first == arm || segment.second == arm;
  });
}

/// How many maps there are, all and minimal; or what a search knows.
std::string counts_text(const MapReport& report, const std::string& planar) {
  std::string text;
  const bool is_searched = report.options.method == "search" && report.complete;
  if (report.consistent == 0U || (is_searched && !report.minimal)) {
    text += fmt::format("no {}map explains the trace{}", planar,
                        report.options.assumptions.empty() ? "" : " under these assumptions");
    if (report.per_visit)
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
  if (report.bounds) text += bounds_text(*report.bounds, report.options.preference.front()) + '\n';
  return text;
}

/// Listed in the report, or counted there where it holds the first alone.
std::size_t number_of_maps(const MapReport& report) {
  if (report.options.all) return report.consistent.value_or(0);
  if (report.minimal) return report.minimal->count;
  return report.bounds && report.bounds->best ? report.bounds->best->count : report.maps.size();
}

}  // namespace

std::string bounds_text(const MapReport::Bounds& bounds, const std::string& first_extent) {
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
    return std::ranges::find(options.preference, extent) != options.preference.end();
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
    text += fmt::format("  place {}: {} {}, star {}\n", index_of(map, place),
                        visits.size() == 1 ? "visit" : "visits", list(visits), place.star.text());
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
  const std::string planar = report.options.planar ? "planar " : "";
  std::string text = fmt::format("{}: {}, {}\n", printable(report.trace), counted(visits, "visit"),
                                 counted(visits - 1, "travel"));
  text += assuming_text(report.options.assumptions);
  text += method_text(report.options);
  if (report.per_visit)
    text += fmt::format("{}maps after each visit: {}\n", planar, fmt::join(*report.per_visit, " "));
  if (!report.complete) {
    text += fmt::format("stopped by {}", report.stopped_by.value_or("a limit"));
    if (report.per_visit && report.per_visit->size() < visits)
      text += fmt::format(" before visit {} was explained\n", report.per_visit->size());
    else
      text += "\n";
  }
  text += counts_text(report, planar);
  const bool are_minimal = !report.options.all && !report.bounds;
  for (std::size_t i = 0; i < std::min(report.maps.size(), most_maps); ++i)
    text += fmt::format("\n{} {}\n", are_minimal ? "model" : "map", i) + map_text(report.maps[i]);
  const std::size_t all = number_of_maps(report);
  if (!report.maps.empty() && all > most_maps)
    text += fmt::format("\n({} more: see --json)\n", all - most_maps);
  return text;
}

std::string refutation_text(const Refutation& refutation, const TopologicalMap& map,
                            const AxiomSet& axioms) {
  std::string text;
  std::vector<std::string> arms;
  for (const PlaceArm arm : refutation.arms) arms.push_back(arm_text(map, arm));
  std::vector<std::size_t> visits;
  for (const VisitId visit : refutation.visits) visits.push_back(visit.index());
  if (refutation.not_planar) {
    text += fmt::format(
        "  planarity: the gateways {} are not on one face, so the travel from visit {} to visit {} "
        "would cross a segment\n",
        fmt::join(arms, " and "), visits[0], visits[1]);
    return text;
  }
  for (const Axiom& axiom : axioms.axioms())
    if (std::find(refutation.axioms.begin(), refutation.axioms.end(), axiom.name) !=
        refutation.axioms.end())
      text += fmt::format("  {:<14} {} {}\n", axiom.name, axiom.words, axiom.source);
  text += fmt::format("  visits {}; {}\n", list(visits), fmt::join(arms, ", "));
  return text;
}

}  // namespace asterism
