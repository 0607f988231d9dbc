#include "cli/commands/map.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include "cli/commands/map_results.hpp"
#include "cli/exit_code.hpp"
#include "cli/progress.hpp"
#include "cli/text/map_text.hpp"
#include "core/error.hpp"
#include "engine/facts.hpp"
#include "engine/minimal/minimal_search.hpp"
#include "io/json/digest.hpp"
#include "mapping/checkpointing.hpp"
#include "mapping/minimal_report.hpp"
#include "mapping/trace_maps.hpp"

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

/// @throws InputError if the file is there and is not to be gone on from: it is another's
void require_checkpoint_file(const MapCommand& command) {
  const std::string& file = *command.checkpoint;
  std::error_code ignored;  // what cannot be asked for cannot be written either
  const auto status = std::filesystem::status(file, ignored);
  if (command.maps.json == file)
    throw InputError("--checkpoint", "the file of --json", "a file of its own");
  if (std::filesystem::exists(status) && !command.resume)
    throw InputError(file, "a file that is there already", "none, or --resume to go on from it");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw InputError(file, "what is no regular file", "a checkpoint");
}

Checkpointing checkpointing(const MapCommand& command, const Trace& trace) {
  require_checkpoint_file(command);
  return Checkpointing(
      {.file = *command.checkpoint,
       .every = std::chrono::duration<double>(command.checkpoint_every_s),
       .failed =
           [](const std::string& why) {
             fmt::print(stderr, "{}; the checkpoint written before stays\n", why);
           }},
      {.trace = trace.name, .digest = digest(trace), .theory = command.maps.options.theory});
}

/// Whether the solver certifies the minimal models, if it is to and there is room to ask it.
bool are_certified(const MinimalSearch& search, const Trace& trace, double certify_s,
                   Progress& progress) {
  // What the solver is asked holds a copy of each.
  const std::size_t model_bytes =
      sizeof(std::vector<Arrival>) + trace.visits.size() * sizeof(Arrival);
  if (certify_s <= 0 || !progress.stop().has_room_for(search.bounds().count * model_bytes))
    return false;
  progress.grown("certifying the minimal models");
  return is_certified(trace, search.options().theory, search.models(),
                      progress.stop().within(certify_s));
}

}  // namespace

int map_minimal(const MapCommand& command, const Theory& theory, const Trace& trace) {
  const MapOptions& options = command.maps.options;
  if (trace.visits.size() > MinimalSearch::max_visits)
    throw InputError(command.maps.trace, fmt::format("{} visits", trace.visits.size()),
                     fmt::format("at most {} with --minimal", MinimalSearch::max_visits));
  Progress progress(trace.visits.size(), options.time_limit_s, options.memory_limit_bytes);
  MinimalSearch search({.theory = theory, .jobs = command.maps.jobs});
  const Stop stop = progress.stop(search);
  search.extend(trace.visits);
  std::optional<Checkpointing> checkpoint;
  if (command.checkpoint) checkpoint = checkpointing(command, trace);
  if (command.resume && !checkpoint->resume(search, stop))
    fmt::print(stderr, "{}: no checkpoint to resume from; the search begins afresh\n",
               *command.checkpoint);

  MapReport report =
      find_minimal(search, trace, options, stop, checkpoint ? &*checkpoint : nullptr);
  if (report.minimal)
    report.minimal->certified = are_certified(search, trace, options.certify_s, progress);
  progress.grown("writing the maps found");

  const std::size_t most = report.complete ? SIZE_MAX : most_maps_so_far;
  const MapSource maps = [&](const auto& write) { for_each_map(search, most, write); };
  for_each_map(search, command.svg_folder ? most_drawings : most_maps_in_text,
               [&](TopologicalMap map) { report.maps.push_back(std::move(map)); });
  write_report(command.maps.json, report, trace.visits.size(), maps);
  if (command.svg_folder) {
    write_models(*command.svg_folder, report, report.maps, search.bounds().count);
    // Of all maps, which an earlier run had listed.
    std::filesystem::remove(std::filesystem::path(*command.svg_folder) / "hypotheses.svg");
  }
  if (command.smt2_folder)
    write_problems(*command.smt2_folder, maps, [&](const TopologicalMap& map) {
      return smt2_text(trace, arrivals(map), theory.axioms);
    });
  if (!report.complete) return exit_undecided;
  if (checkpoint) checkpoint->remove();
  return report.minimal ? exit_consistent : exit_inconsistent;
}

}  // namespace asterism
