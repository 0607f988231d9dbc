#include "cli/ssh_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <span>
#include <stdexcept>
#include <utility>

#include "axioms/axiom_solver.hpp"
#include "cli/map_parts.hpp"
#include "cli/map_text.hpp"
#include "cli/progress.hpp"
#include "cli/ssh_text.hpp"
#include "core/error.hpp"
#include "engine/ssh_certify.hpp"
#include "engine/ssh_table.hpp"
#include "engine/ssh_tree.hpp"
#include "io/atomic_file.hpp"
#include "io/ssh_map_svg.hpp"
#include "io/ssh_maps_file.hpp"
#include "planarity/straight_drawing.hpp"

namespace asterism {
namespace {

constexpr std::size_t most_maps_in_text = 20;
constexpr std::size_t most_drawings = 100;

/// Grows the tree by the whole experience: view by view where something can stop it early, to end
/// on a whole level.
/// @return  what stopped it, if anything did
std::optional<std::string> grow(SshTree& tree, std::size_t views, const MapCommand& command,
                                Progress& progress) {
  const bool may_stop = command.options.max_hypotheses || command.options.time_limit_s ||
                        command.options.memory_limit_bytes || command.options.check != "native";
  const std::size_t step = may_stop ? 1 : views;
  for (std::size_t k = 0; k < views; k += step) {
    if (may_stop && !progress(k, tree.size())) return progress.stopped_by();
    switch (tree.grow(step)) {
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

SshReport report_of(const SshTree& tree, const Experience& experience, const MapCommand& command,
                    const AxiomSet& axioms, std::optional<std::string> stopped_by,
                    Progress& progress) {
  SshReport report{.experience = experience, .options = command.options};
  report.options.preference = axioms.preference();
  if (tree.views() > 0) report.per_view.emplace(tree.per_view().begin(), tree.per_view().end());
  report.stopped_by = std::move(stopped_by);
  if (!report.stopped_by && tree.undecided() > 0)
    report.stopped_by = fmt::format("{} candidates undecided by the solver", tree.undecided());
  report.complete = !report.stopped_by;
  if (tree.views() < experience.views.size()) return report;

  report.consistent = tree.size();
  if (tree.size() == 0) return report;
  report.maps = tree.minimal();
  report.minimal = {.paths = report.maps.front().number_of_paths(),
                    .places = report.maps.front().number_of_places(),
                    .count = report.maps.size(),
                    .certified = false};
  if (command.options.certify_s > 0) {
    progress.grown("certifying the minimal models");
    const double seconds =
        std::min(command.options.certify_s, progress.seconds_left().value_or(1e9));
    const Certificate certificate =
        certify(experience, axioms, command.options.planar, report.maps, seconds);
    // What was kept undecided may well be refuted, given more time.
    if (certificate == Certificate::refuted && tree.undecided() == 0)
      throw std::logic_error("the solver refutes the minimal models of the tree");
    report.minimal->certified = certificate == Certificate::shown;
  }
  return report;
}

/// The grounded problem of each map, as SMT-LIB 2.
void write_problems(const std::filesystem::path& folder, const Experience& experience,
                    const SshMapSource& maps, const AxiomSet& axioms) {
  make_folder(folder);
  const SshTable table(experience);
  std::size_t number = 0;
  maps([&](const SshMap& map) {
    std::vector<Fact> facts = table.general_facts();
    std::vector<SshTable::DState> dstates;
    for (const DStateId dstate : map.dstates) {
      dstates.push_back(static_cast<SshTable::DState>(dstate.index()));
      const auto more = table.step_facts(dstates);
      facts.insert(facts.end(), more.begin(), more.end());
    }
    write_atomically((folder / fmt::format("map-{}.smt2", number++)).string(),
                     smt2_text(axioms, facts, printable(experience.name)));
  });
  remove_from(folder, "map-{}.smt2", number);
}

void write_drawings(const std::filesystem::path& folder, const SshReport& report,
                    std::span<const SshMap> models) {
  make_folder(folder);
  const std::size_t drawings = std::min(models.size(), most_drawings);
  for (std::size_t i = 0; i < drawings; ++i)
    write_atomically(
        (folder / fmt::format("model-{}.svg", i)).string(),
        ssh_map_svg(models[i],
                    draw_straight(models[i].number_of_places(), edges_of(models[i])).vertices,
                    fmt::format("{}, {}minimal model {} (of {})", report.experience.name,
                                report.options.planar ? "planar " : "", i, models.size())));
  remove_from(folder, "model-{}.svg", drawings);
  if (drawings < models.size())
    fmt::print(stderr, "drew the first {} of {} minimal models\n", drawings, models.size());
}

}  // namespace

int map_experience(MapCommand& command, const Experience& experience) {
  if (!command.why_not.empty())
    throw InputError("--why-not", "a trace of the basic SSH", "a trace with stars");
  if (!command.assume.empty())
    throw InputError("--assume", "a trace of the basic SSH", "a trace with stars");
  const AxiomSet axioms = read_axioms(command);
  if (command.minimal) command.options.method = "listing";
  require_no_checkpoint(command, "a trace of the basic SSH", "a trace with stars");
  Progress progress(experience.views.size(), command.options.time_limit_s,
                    command.options.memory_limit_bytes);
  MapTree::Options options = tree_options(command, axioms);
  options.go_on = std::ref(progress);
  SshTree tree(experience, std::move(options));
  std::optional<std::string> stopped_by = grow(tree, experience.views.size(), command, progress);
  SshReport report = report_of(tree, experience, command, axioms, std::move(stopped_by), progress);

  const std::vector<SshMap> models = report.maps;
  SshMapSource maps = [&](const auto& write) {
    for (const SshMap& map : models) write(map);
  };
  if (command.options.all && report.consistent) {
    maps = [&](const auto& write) { tree.for_each(write); };
    report.maps.clear();
    maps([&](const SshMap& map) {
      if (report.maps.size() <= most_maps_in_text) report.maps.push_back(map);
    });
  }
  if (command.json == "-") {
    write_maps(std::cout, report, maps);
  } else {
    if (command.json)
      write_atomically(*command.json, [&](std::ostream& out) { write_maps(out, report, maps); });
    fmt::print("{}", report_text(report, most_maps_in_text));
  }
  if (command.svg_folder) write_drawings(*command.svg_folder, report, models);
  if (command.smt2_folder) write_problems(*command.smt2_folder, experience, maps, axioms);
  if (!report.complete) return exit_undecided;
  return report.consistent.value_or(0) > 0 ? exit_consistent : exit_inconsistent;
}

}  // namespace asterism
