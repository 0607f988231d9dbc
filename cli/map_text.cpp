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

}  // namespace

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
  if (report.per_visit)
    text += fmt::format("{}maps after each visit: {}\n", planar, fmt::join(*report.per_visit, " "));
  if (!report.complete) {
    text += fmt::format("stopped by {}", report.stopped_by.value_or("a limit"));
    if (report.per_visit && report.per_visit->size() < visits)
      text += fmt::format(" before visit {} was explained\n", report.per_visit->size());
    else
      text += "\n";
  }
  if (report.consistent) {
    const auto explained = [&] {
      return report.per_visit
                 ? static_cast<std::size_t>(std::ranges::find(*report.per_visit, std::uint64_t{0}) -
                                            report.per_visit->begin())
                 : report.explained_visits.value_or(0);
    };
    if (*report.consistent == 0)
      text += fmt::format("no {}map explains the trace{}: none is left after visit {}\n", planar,
                          report.options.assumptions.empty() ? "" : " under these assumptions",
                          explained());
    else
      text += fmt::format("{} {} the trace\n", counted(*report.consistent, planar + "map"),
                          *report.consistent == 1 ? "explains" : "explain");
  }
  if (report.minimal) {
    const auto& minimal = *report.minimal;
    text += fmt::format("{}: {}, {}; {}\n", counted(minimal.count, "minimal model"),
                        counted(minimal.paths, "path"), counted(minimal.places, "place"),
                        minimal.certified ? "certified by the solver"
                        : report.options.certify_s > 0
                            ? fmt::format("not certified within {} s", report.options.certify_s)
                            : "not certified");
  }
  for (std::size_t i = 0; i < std::min(report.maps.size(), most_maps); ++i)
    text += fmt::format("\n{} {}\n", report.options.all ? "map" : "model", i) +
            map_text(report.maps[i]);
  const std::size_t all = report.options.all ? report.consistent.value_or(0) : report.maps.size();
  if (all > most_maps) text += fmt::format("\n({} more: see --json)\n", all - most_maps);
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
