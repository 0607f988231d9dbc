#include "cli/map_minimal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <utility>

#include "cli/checkpointing.hpp"
#include "cli/grow.hpp"
#include "cli/map_results.hpp"
#include "cli/map_text.hpp"
#include "cli/progress.hpp"
#include "core/error.hpp"
#include "engine/explained_visits.hpp"
#include "engine/minimal_search.hpp"

namespace asterism {
namespace {

/// Written out where a limit ended the search; of more, only the number is told. There may be
/// millions, and neither time nor memory left.
constexpr std::size_t most_maps_so_far = 100;

/// Calls write(map) for each of the maps found, or for the first so many.
void for_each_map(const MinimalSearch& search, std::size_t most, const auto& write) {
  search.for_each_while(
      [&](auto model) {
        write(make_map(search.trace(), model));
        return true;
      },
      most);
}

/// What a search takes before it finds anything: a bit for every two arms of the trace, for each
/// worker, two a thread, for the folding they begin with, and while it looks around.
std::uint64_t bytes_at_begin(const MinimalSearch& search) {
  std::uint64_t arms = 0;
  for (const Visit& visit : search.trace().visits) arms += visit.star.size();
  return (2 * search.options().jobs + 2) * arms * arms / 8;
}

/// Searches until all is known or something stops it.
/// @return  what did
std::optional<std::string> search_on(MinimalSearch& search, const MapCommand& command,
                                     std::optional<Checkpointing>& checkpoint, Progress& progress) {
  const std::string first_extent = search.options().axioms.preference().front();
  const std::uint64_t at_begin = bytes_at_begin(search);
  const auto go_on = [&](const MinimalSearch& running) {
    const std::uint64_t held = running.memory_bytes();
    // The list of the maps found is copied as it grows; a checkpoint copies all of it.
    const std::uint64_t listed = running.bounds().count * sizeof(SearchState::Model);
    const std::uint64_t to_come =
        (at_begin > held ? at_begin - held : 0) + listed + (command.checkpoint ? held : 0);
    return progress([&] { return bounds_text(bounds_of(running), first_extent); }, to_come);
  };
  if (!progress.has_room(at_begin)) return "memory limit";
  const auto outcome = checkpoint ? checkpoint->run(search, go_on) : search.run(go_on);
  if (outcome == MinimalSearch::Outcome::complete) return std::nullopt;
  return progress.stopped_by();
}

}  // namespace

int map_minimal(const MapCommand& command, const AxiomSet& axioms, const Trace& trace) {
  if (trace.visits.size() > MinimalSearch::max_visits)
    throw InputError(command.trace, fmt::format("{} visits", trace.visits.size()),
                     fmt::format("at most {} with --minimal", MinimalSearch::max_visits));
  Progress progress(trace.visits.size(), command.options.time_limit_s,
                    command.options.memory_limit_bytes);
  MinimalSearch search({.planar = command.options.planar,
                        .axioms = axioms,
                        .assumptions = command.options.assumptions,
                        .jobs = command.jobs});
  search.extend(trace.visits);
  std::optional<Checkpointing> checkpoint;
  if (command.checkpoint) checkpoint.emplace(command, axioms, trace);
  if (command.resume) checkpoint->resume(search, progress);

  MapReport report;
  report.trace = trace.name;
  report.options = command.options;
  report.options.preference = axioms.preference();
  report.stopped_by = search_on(search, command, checkpoint, progress);
  report.complete = !report.stopped_by;
  const MapReport::Bounds known = bounds_of(search);
  if (!report.complete) {
    report.bounds = known;
  } else if (known.best) {
    report.minimal = {known.best->paths, known.best->places, known.best->count, false};
    // What the solver is asked holds a copy of each.
    const std::size_t model_bytes = sizeof(std::vector<Arrival>) + command.visits * sizeof(Arrival);
    if (command.options.certify_s > 0 && progress.has_room(known.best->count * model_bytes))
      report.minimal->certified = is_certified(trace, search.models(), command, axioms, progress);
  } else {
    report.consistent = 0;
    report.explained_visits = explained_visits(
        trace, search.options(), [&](const auto& now) { return progress.searched(now); });
  }
  progress.grown("writing the maps found");

  const std::size_t most = report.complete ? SIZE_MAX : most_maps_so_far;
  const MapSource maps = [&](const auto& write) { for_each_map(search, most, write); };
  for_each_map(search, command.svg_folder ? most_drawings : most_maps_in_text,
               [&](TopologicalMap map) { report.maps.push_back(std::move(map)); });
  write_report(command, report, maps);
  if (command.svg_folder) {
    write_models(command, report, report.maps, known.best ? known.best->count : 0);
    // Of all maps, which an earlier run had listed.
    std::filesystem::remove(std::filesystem::path(*command.svg_folder) / "hypotheses.svg");
  }
  write_problems(command, axioms, trace, maps);
  if (!report.complete) return exit_undecided;
  if (checkpoint) checkpoint->remove();
  return report.minimal ? exit_consistent : exit_inconsistent;
}

}  // namespace asterism
