#include <algorithm>
#include <filesystem>
#include <utility>

#include "axioms/smt2_text.hpp"
#include "cli/commands/map.hpp"
#include "cli/commands/map_results.hpp"
#include "cli/exit_code.hpp"
#include "cli/progress.hpp"
#include "cli/text/map_text.hpp"
#include "core/error.hpp"
#include "engine/facts.hpp"
#include "engine/ssh/ssh_table.hpp"
#include "io/atomic_file.hpp"
#include "io/picture/chart_svg.hpp"
#include "mapping/ssh_maps.hpp"
#include "mapping/trace_maps.hpp"

namespace asterism {
namespace {

std::string problem_text(const TraceMaps& found, const TopologicalMap& map) {
  return smt2_text(found.trace(), arrivals(map), found.theory().axioms);
}

std::string problem_text(const SshMaps& found, const SshMap& map) {
  const SshTable table(found.experience());
  std::vector<Fact> facts = table.general_facts();
  for (std::size_t k = 0; k < map.dstates.size(); ++k)
    std::ranges::copy(table.step_facts(std::span(map.dstates).first(k + 1)),
                      std::back_inserter(facts));
  return smt2_text(found.theory().axioms, facts, printable(found.experience().name));
}

/// Of how many maps there were after each visit, with and without planarity.
void draw_chart(const MapCommand& command, const TraceMaps& maps, const MapReport& report,
                const Progress& progress) {
  const auto own = report.per_visit.value_or(std::vector<std::uint64_t>{});
  TraceMaps other = maps.under_other_view();
  Progress counting(maps.steps(), progress.seconds_left(), maps.options().memory_limit_bytes);
  other.find(counting.stop());
  const bool is_planar = maps.theory().planar;
  write_atomically((std::filesystem::path(*command.svg_folder) / "hypotheses.svg").string(),
                   hypotheses_chart_svg(report.trace, is_planar ? other.per_visit() : own,
                                        is_planar ? own : other.per_visit()));
}

void draw_chart(const MapCommand&, const SshMaps&, const SshReport&, const Progress&) {}

/// Lists the maps of either kind of trace.
template <class Maps>
int list_maps(const MapCommand& command, Maps found) {
  const MapOptions& options = command.maps.options;
  Progress progress(found.steps(), options.time_limit_s, options.memory_limit_bytes);
  found.find(progress.stop());
  auto report = found.report(progress.stop());
  if (report.minimal && options.certify_s > 0) {
    progress.grown("certifying the minimal models");
    report.minimal->certified = found.are_certified(progress.stop().within(options.certify_s));
  }
  const auto models = report.maps;
  auto maps = each_of(models);
  if (options.all && report.consistent) {
    report.maps.clear();
    if (auto all = found.all_in_order(progress.stop())) {
      maps = *std::move(all);
      maps([&](const auto& map) {
        if (report.maps.size() <= most_maps_in_text) report.maps.push_back(map);
      });
    } else {
      maps = [](const auto&) {};
      report.stopped_by = "memory limit";
      report.complete = false;
      report.minimal.reset();
    }
  }
  write_report(command.maps.json, report, found.steps(), maps);
  if (command.svg_folder) {
    write_models(*command.svg_folder, report, models, models.size());
    draw_chart(command, found, report, progress);
  }
  if (command.smt2_folder)
    write_problems(*command.smt2_folder, maps,
                   [&](const auto& map) { return problem_text(found, map); });
  if (!report.complete) return exit_undecided;
  return report.consistent.value_or(0) > 0 ? exit_consistent : exit_inconsistent;
}

}  // namespace

int map_trace(const MapCommand& command, const Theory& theory, const Trace& trace) {
  require_no_checkpoint(command, "a search that lists all maps", "shipped axioms and no --check");
  return list_maps(command, TraceMaps(trace, theory, command.maps.options));
}

int map_experience(MapCommand& command, const Experience& experience) {
  if (!command.why_not.empty())
    throw InputError("--why-not", "a trace of the basic SSH", "a trace with stars");
  if (!command.maps.assume.empty())
    throw InputError("--assume", "a trace of the basic SSH", "a trace with stars");
  const Theory theory = read_theory(command);
  if (theory.axioms.minimises_own())
    throw InputError("--axioms", other_than_shipped(theory.axioms),
                     "path, place and segment alone with a trace of the basic SSH");
  if (command.maps.only_minimal) command.maps.options.method = "listing";
  require_no_checkpoint(command, "a trace of the basic SSH", "a trace with stars");
  return list_maps(command, SshMaps(experience, theory, command.maps.options));
}

}  // namespace asterism
