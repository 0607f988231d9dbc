#include "mapping/explained_trace.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "engine/proof/explain.hpp"
#include "mapping/trace_parts.hpp"

namespace asterism {
namespace {

constexpr double most_why_s = 10;      // for the solver to name the axioms against a visit
constexpr double most_cutting_s = 60;  // to find out where to cut a trace

/// The maps of each part that a trace is cut into; none if these are not all to be had.
std::vector<TraceMaps> maps_of_parts(const Trace& trace, const Theory& theory,
                                     const MapOptions& options, bool only_minimal,
                                     const MapWatch& watch, const Stop& stop) {
  auto ends = cuts_of(trace, theory, options, stop.within(most_cutting_s));
  if (!ends) return {};
  ends->push_back(trace.visits.size());
  std::vector<TraceMaps> parts;
  std::size_t first = 0;
  for (const std::size_t last : *ends) {
    parts.emplace_back(part_of(trace, first, last), theory_of_part(theory, first, last), options,
                       only_minimal);
    if (parts.back().find(watch.stop(parts.back()))) return {};
    first = last;
  }
  return parts;
}

}  // namespace

ExplainedTrace explain_trace(const Trace& trace, const Theory& theory, const MapOptions& options,
                             bool only_minimal, const MapWatch& watch) {
  TraceMaps maps(trace, theory, options, only_minimal);
  const Stop stop = watch.stop(maps);
  maps.find(stop);
  MapReport report = maps.report(stop);
  if (report.minimal && options.certify_s > 0) {
    watch.found("certifying the minimal models");
    report.minimal->certified = maps.are_certified(stop.within(options.certify_s));
  }
  std::vector<std::uint64_t> other_per_visit;
  if (!maps.are_searched()) {
    TraceMaps other = maps.under_other_view();
    other.find(watch.stop(other));
    other_per_visit = other.per_visit();
  }
  const std::size_t explained = maps.explained_visits();
  std::string why;
  std::vector<TraceMaps> parts;
  if (explained < trace.visits.size()) {
    maps.keep_explained(stop);
    report.stopped_by = maps.stopped_by();
    report.complete = !report.stopped_by;
    if (explained > 0) report.explained_visits = explained;
    if (report.stopped_by)
      why =
          fmt::format("{} was stopped: {}", maps.are_searched() ? "the search" : "growing the tree",
                      *report.stopped_by);
    else if (explained == 0)
      why = fmt::format("visit 0 is at no place, assuming {}", text_of(theory.assumptions));
    else
      parts = maps_of_parts(trace, theory, options, only_minimal, watch, stop);
  }
  return {std::move(maps), std::move(report), std::move(other_per_visit), std::move(why),
          std::move(parts)};
}

std::string why_no_more(const Trace& trace, const TopologicalMap& map, const Theory& theory) {
  const std::size_t k = map.visits.size();
  const std::string assumed =
      theory.assumptions.empty() ? "" : fmt::format(", assuming {}", text_of(theory.assumptions));
  const PlaceArm left{map.visits.back(), map.left.back().value()};
  for (const auto& [one, other] : map.segments) {
    if (one != left && other != left) continue;
    const PlaceArm reached = one == left ? other : one;
    const TopologicalMap::Place& place = map.places[reached.place.index()];
    std::vector<Arrival> child = arrivals(map);
    child.push_back({reached.place, reached.arm});
    const VisitId here = map.places[left.place.index()].first_visit;
    std::string names;
    const Reason reason = explain_candidate(trace, theory, child, Stop{}.within(most_why_s));
    for (const auto& [premise, without] : reason.clash.members)
      if (premise.kind == Premise::Kind::axiom)
        names += (names.empty() ? "" : ", ") + theory.axioms.axioms()[premise.number].name;
    if (names.empty() && !assumed.empty())
      return fmt::format(
          "visit {} came by the known way from the place of visit {} to that of visit {}, and was "
          "not there{}",
          k, here.index(), place.first_visit.index(), assumed);
    return fmt::format(
        "visit {} came by the known way from the place of visit {} to that of visit {}, in by arm "
        "{} of {}; it saw {}, in by arm {}{}",
        k, here.index(), place.first_visit.index(), place.star.name(reached.arm), place.star.text(),
        trace.visits[k].star.text(), trace.visits[k].star.name(trace.visits[k].entered_by.value()),
        names.empty() ? "" : fmt::format(" (against {})", names));
  }
  return fmt::format("visit {} is at no place, known or new{}", k, assumed);
}

}  // namespace asterism
