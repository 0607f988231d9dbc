#include "cli/asked_maps.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "cli/grow.hpp"
#include "cli/map_parts.hpp"
#include "engine/explained_visits.hpp"

namespace asterism {
namespace {

std::variant<MapTree, MinimalSearch> none_yet(const MapCommand& command, const AxiomSet& axioms,
                                              const Trace& trace, bool only_minimal,
                                              Progress& progress) {
  const MapOptions& options = command.options;
  if (only_minimal && options.check == "native" && !options.max_hypotheses &&
      trace.visits.size() <= MinimalSearch::max_visits)
    return MinimalSearch({.planar = options.planar,
                          .axioms = axioms,
                          .assumptions = options.assumptions,
                          .jobs = command.jobs});
  MapTree::Options of_tree = tree_options(command, axioms);
  of_tree.go_on = std::ref(progress);
  return MapTree(std::move(of_tree));
}

}  // namespace

AskedMaps::AskedMaps(const MapCommand& command, const AxiomSet& axioms, const Trace& trace,
                     bool only_minimal, Progress& progress)
    : command_(command),
      trace_(trace),
      only_minimal_(only_minimal),
      progress_(progress),
      found_(none_yet(command, axioms, trace, only_minimal, progress)) {}

std::optional<std::string> AskedMaps::find() {
  if (auto* search = std::get_if<MinimalSearch>(&found_)) return run(*search);
  auto& tree = std::get<MapTree>(found_);
  auto stopped_by = grow(tree, trace_, command_, progress_);
  if (!stopped_by && tree.undecided() > 0) stopped_by = undecided_text(tree);
  return stopped_by;
}

std::optional<std::string> AskedMaps::run(MinimalSearch& search) {
  const auto go_on = [&](const MinimalSearch& now) { return progress_.searched(now); };
  search.extend(trace_.visits);
  if (search.run(go_on) == MinimalSearch::Outcome::stopped) return progress_.stopped_by();
  searched_visits_ = trace_.visits.size();
  if (search.bounds().count > 0) return std::nullopt;
  const auto explained = asterism::explained_visits(trace_, search.options(), go_on);
  if (!explained) return progress_.stopped_by();
  searched_visits_ = *explained;
  return std::nullopt;
}

MapList AskedMaps::minimal() const {
  return are_searched() ? minimal_maps(search()) : minimal_maps(tree());
}

MapList AskedMaps::list() const { return only_minimal_ ? minimal() : all_maps(tree()); }

std::optional<std::uint64_t> AskedMaps::consistent() const {
  if (!are_searched()) return tree().size();
  if (search().is_complete() && search().bounds().count == 0) return 0;
  return std::nullopt;
}

std::size_t AskedMaps::explained_visits() const {
  if (are_searched()) return searched_visits_;
  const auto counts = tree().per_visit();
  return static_cast<std::size_t>(std::ranges::find(counts, std::uint64_t{0}) - counts.begin());
}

}  // namespace asterism
