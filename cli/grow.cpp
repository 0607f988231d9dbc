#include "cli/grow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <span>
#include <stdexcept>
#include <utility>

#include "cli/map_parts.hpp"
#include "engine/certify.hpp"
#include "engine/minimal_models.hpp"

namespace asterism {
namespace {

constexpr std::uint64_t most_maps_in_chart = 10'000'000;

/// What a minimal model takes as a map and as a data association, about.
std::uint64_t model_bytes(std::size_t visits) { return 1000 + 300 * visits; }

MapReport empty_report(const MapCommand& command, const AxiomSet& axioms,
                       std::optional<std::string> stopped_by) {
  MapReport report;
  report.options = command.options;
  report.options.preference = axioms.preference();
  report.stopped_by = std::move(stopped_by);
  report.complete = !report.stopped_by;
  return report;
}

/// @param may_be_refuted  since the solver owes answers: given more time, it may well refute
/// @throws std::logic_error if the solver refutes the models otherwise
void add_minimal(MapReport& report, const Trace& trace,
                 const std::vector<std::vector<Arrival>>& models, const MapCommand& command,
                 const AxiomSet& axioms, Progress& progress, bool may_be_refuted) {
  for (const auto& model : models) report.maps.push_back(make_map(trace, model));
  report.minimal = {.paths = report.maps.front().paths.size(),
                    .places = report.maps.front().places.size(),
                    .count = models.size(),
                    .certified = false};
  report.minimal->certified =
      is_certified(trace, models, command, axioms, progress, may_be_refuted);
}

}  // namespace

bool is_certified(const Trace& trace, const std::vector<std::vector<Arrival>>& models,
                  const MapCommand& command, const AxiomSet& axioms, Progress& progress,
                  bool may_be_refuted) {
  if (command.options.certify_s <= 0) return false;
  progress.grown("certifying the minimal models");
  const double seconds = std::min(command.options.certify_s, progress.seconds_left().value_or(1e9));
  const Certificate certificate =
      certify(trace, axioms, command.options.planar, models, seconds, command.options.assumptions);
  if (certificate == Certificate::refuted && !may_be_refuted)
    throw std::logic_error("the solver refutes the minimal models");
  return certificate == Certificate::shown;
}

std::optional<std::string> grow(MapTree& tree, const Trace& trace, const MapCommand& command,
                                Progress& progress) {
  const bool may_stop = command.options.max_hypotheses || command.options.time_limit_s ||
                        command.options.memory_limit_bytes || command.options.check != "native";
  const std::size_t step = may_stop ? 1 : trace.visits.size();
  for (std::size_t k = 0; k < trace.visits.size(); k += step) {
    // The tree asks now and then within a level; a small one is over before.
    if (may_stop && !progress(k, tree.size())) return progress.stopped_by();
    switch (tree.extend(std::span(trace.visits).subspan(k, step))) {
      case MapTree::Growth::complete:
        break;
      case MapTree::Growth::stopped:
        return progress.stopped_by();
      case MapTree::Growth::too_many:
        return fmt::format("limit of {} hypotheses", *command.options.max_hypotheses);
    }
  }
  return std::nullopt;
}

std::string undecided_text(const MapTree& tree) {
  return fmt::format("{} candidates undecided by the solver", tree.undecided());
}

MapReport report_of(const MapTree& tree, const MapCommand& command, const AxiomSet& axioms,
                    std::optional<std::string> stopped_by, Progress& progress) {
  if (!stopped_by && tree.undecided() > 0) stopped_by = undecided_text(tree);
  MapReport report = empty_report(command, axioms, std::move(stopped_by));
  report.per_visit = std::vector(tree.per_visit().begin(), tree.per_visit().end());
  if (report.per_visit->empty()) report.per_visit.reset();
  if (tree.trace().visits.size() < command.visits) return report;
  report.consistent = tree.size();
  if (tree.size() == 0) return report;
  if (!progress.has_room(tree.minimal().size() * model_bytes(command.visits))) {
    report.stopped_by = "memory limit";
    report.complete = false;
    return report;
  }
  add_minimal(report, tree.trace(), minimal_models(tree), command, axioms, progress,
              tree.undecided() > 0);
  return report;
}

MapReport report_of(const MinimalSearch& search, const MapCommand& command, const AxiomSet& axioms,
                    std::optional<std::string> stopped_by, Progress& progress) {
  MapReport report = empty_report(command, axioms, std::move(stopped_by));
  if (!search.is_complete()) return report;
  if (search.bounds().count == 0)
    report.consistent = 0;
  else
    add_minimal(report, search.trace(), search.models(), command, axioms, progress, false);
  return report;
}

std::vector<std::uint64_t> other_counts(const MapCommand& command, const AxiomSet& axioms,
                                        const Trace& trace) {
  MapCommand other = command;
  other.options.planar = !command.options.planar;
  if (axioms.is_shipped()) other.options.check = "native";
  other.options.max_hypotheses =
      std::min(other.options.max_hypotheses.value_or(UINT64_MAX), most_maps_in_chart);
  Progress progress(trace.visits.size(), command.options.time_limit_s,
                    command.options.memory_limit_bytes);
  MapTree::Options options = tree_options(other, axioms);
  options.go_on = std::ref(progress);
  MapTree tree(std::move(options));
  grow(tree, trace, other, progress);
  return {tree.per_visit().begin(), tree.per_visit().end()};
}

MapReport::Bounds bounds_of(const MinimalSearch& search) {
  const auto [at_least, best, count] = search.bounds();
  MapReport::Bounds bounds{.at_least = at_least, .best = {}};
  if (best) bounds.best = {best->paths, best->places, count};
  return bounds;
}

}  // namespace asterism
