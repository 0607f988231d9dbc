#include "mapping/trace_maps.hpp"

#include <algorithm>
#include <chrono>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "axioms/axiom_solver.hpp"
#include "engine/minimal/longest_explained_prefix.hpp"
#include "engine/minimal/minimal_models.hpp"
#include "engine/preference.hpp"
#include "mapping/growing.hpp"
#include "mapping/own_process.hpp"
#include "mapping/sorted_maps.hpp"

namespace asterism {
namespace {

constexpr std::uint64_t most_maps_in_chart = 10'000'000;

// What a certification may take of memory, and past its deadline before it is killed.
constexpr std::uint64_t most_solver_bytes = std::uint64_t{2} << 30;
constexpr std::chrono::milliseconds grace{500};

/// What a minimal model takes as a map and as a data association, about.
std::uint64_t model_bytes(std::size_t visits) { return 1000 + 300 * visits; }

std::variant<MapTree, MinimalSearch> none_yet(const Trace& trace, const Theory& theory,
                                              const MapOptions& options, bool only_minimal,
                                              unsigned jobs) {
  if (only_minimal && options.check == "native" && !options.max_hypotheses &&
      trace.visits.size() <= MinimalSearch::max_visits)
    return MinimalSearch({.theory = theory, .jobs = jobs});
  return MapTree(tree_options(theory, options));
}

}  // namespace

TraceMaps::TraceMaps(Trace trace, Theory theory, MapOptions options, bool only_minimal,
                     unsigned jobs)
    : trace_(std::move(trace)),
      theory_(std::move(theory)),
      options_(std::move(options)),
      only_minimal_(only_minimal),
      found_(none_yet(trace_, theory_, options_, only_minimal, jobs)) {
  options_.theory.preference = theory_.axioms.preference_names();
}

std::optional<std::string> TraceMaps::find(const Stop& stop) {
  if (auto* search = std::get_if<MinimalSearch>(&found_)) return stopped_by_ = run(*search, stop);
  auto& tree = std::get<MapTree>(found_);
  return stopped_by_ = grow_all(tree, steps(), options_, stop, [&](std::size_t k, std::size_t n) {
           return tree.extend(std::span(trace_.visits).subspan(k, n), stop);
         });
}

std::optional<std::string> TraceMaps::run(MinimalSearch& search, const Stop& stop) {
  search.extend(trace_.visits);
  if (search.run(stop) == MinimalSearch::Outcome::stopped) return stop.reason;
  searched_visits_ = trace_.visits.size();
  if (search.bounds().count > 0) return std::nullopt;
  const auto explained = longest_explained_prefix(trace_, search.options(), stop);
  searched_visits_ = explained.value_or(0);
  return explained ? std::nullopt : stop.reason;
}

void TraceMaps::keep_explained(const Stop& stop) {
  const std::size_t looked_at = minimal().trace.visits.size();
  trace_.visits.erase(trace_.visits.begin() + static_cast<std::ptrdiff_t>(explained_visits()),
                      trace_.visits.end());
  if (trace_.visits.size() >= looked_at) return;
  if (const auto* search = std::get_if<MinimalSearch>(&found_)) {
    MinimalSearch part(search->options());
    part.extend(trace_.visits);
    part.run(stop);
    if (!part.is_complete()) stopped_by_ = stop.reason;
    found_ = std::move(part);
  } else {
    MapTree part(tree().options());
    part.extend(trace_.visits);
    found_ = std::move(part);
  }
}

MapList TraceMaps::minimal() const {
  return std::visit([](const auto& maps) { return minimal_maps(maps); }, found_);
}

MapList TraceMaps::list() const { return only_minimal_ ? minimal() : all_maps(tree()); }

std::optional<std::uint64_t> TraceMaps::consistent() const {
  if (!are_searched()) return tree().size();
  if (search().is_complete() && search().bounds().count == 0) return 0;
  return std::nullopt;
}

std::vector<std::uint64_t> TraceMaps::per_visit() const {
  if (are_searched()) return {};
  return {tree().per_visit().begin(), tree().per_visit().end()};
}

std::size_t TraceMaps::explained_visits() const {
  if (are_searched()) {
    // A search that was stopped may know some maps of the whole trace.
    const bool are_some_known = stopped_by_ && search().bounds().count > 0;
    return are_some_known ? trace_.visits.size() : searched_visits_;
  }
  const auto counts = tree().per_visit();
  return static_cast<std::size_t>(std::ranges::find(counts, std::uint64_t{0}) - counts.begin());
}

MapReport TraceMaps::report(const Stop& stop) const {
  MapReport report{{.trace = trace_.name, .options = options_}};
  report.stopped_by = stopped_by_;
  if (!per_visit().empty()) report.per_visit = per_visit();
  const bool is_whole = are_searched() ? search().is_complete()
                                       : tree().trace().visits.size() == trace_.visits.size();
  if (is_whole) report.consistent = consistent();
  if (is_whole && report.consistent != 0) {
    if (are_searched() || stop.has_room_for(minimal().size * model_bytes(trace_.visits.size())))
      add_minimal(report);
    else
      report.stopped_by = "memory limit";
  }
  report.complete = !report.stopped_by;
  return report;
}

void TraceMaps::add_minimal(MapReport& report) const {
  const std::vector<std::vector<Arrival>> found = models();
  for (const auto& model : found) report.maps.push_back(make_map(trace_, model));
  report.minimal = {.paths = report.maps.front().paths.size(),
                    .places = report.maps.front().places.size(),
                    .count = report.maps.size(),
                    .certified = false};
  const auto sizes = extents_by_preference(trace_, found.front(), theory_.axioms);
  for (std::size_t i = 0; i < sizes.size(); ++i)
    if (const ExtentDeclaration& extent = theory_.axioms.minimised()[i]; !extent.known)
      report.own_extents.emplace_back(extent.name, sizes[i]);
}

std::vector<std::vector<Arrival>> TraceMaps::models() const {
  return are_searched() ? search().models() : minimal_models(tree());
}

std::optional<MapSource> TraceMaps::all_in_order(const Stop& stop) const {
  if (!stop.has_room_for(tree().size() * SortedMaps::bytes(steps()))) return std::nullopt;
  return [sorted = SortedMaps(tree())](const auto& write) { sorted.for_each(write); };
}

bool TraceMaps::are_certified(const Stop& stop) const {
  return is_certified(trace_, theory_, models(), stop, !are_searched() && tree().undecided() > 0);
}

TraceMaps TraceMaps::under_other_view() const {
  Theory theory = theory_;
  theory.planar = !theory.planar;
  MapOptions options = options_;
  options.theory.planar = theory.planar;
  if (theory.axioms.is_shipped()) options.check = "native";
  options.max_hypotheses =
      std::min(options.max_hypotheses.value_or(UINT64_MAX), most_maps_in_chart);
  return {trace_, std::move(theory), std::move(options)};
}

MapTree::Options tree_options(const Theory& theory, const MapOptions& options) {
  return {.theory = theory,
          .check = options.check == "native"   ? Check::native
                   : options.check == "solver" ? Check::solver
                                               : Check::both,
          .max_hypotheses = options.max_hypotheses.value_or(UINT64_MAX)};
}

MapReport::Bounds bounds_of(const MinimalSearch& search) {
  const auto [at_least, best, count] = search.bounds();
  MapReport::Bounds bounds{.at_least = at_least, .best = {}};
  if (best) bounds.best = {best->paths, best->places, count};
  return bounds;
}

bool is_certified(const Trace& trace, const Theory& theory,
                  const std::vector<std::vector<Arrival>>& models, const Stop& stop,
                  bool may_be_refuted) {
  return is_shown([&] { return certify(trace, theory, models, stop); }, stop, may_be_refuted);
}

bool is_shown(const std::function<Certificate()>& certify, const Stop& stop, bool may_be_refuted) {
  const auto work = [&] {
    limit_solver_memory(most_solver_bytes);
    return std::string(1, static_cast<char>(certify()));
  };
  const bool is_open_ended = stop.deadline == Deadline::max();
  const auto told = in_own_process(work, is_open_ended ? stop.deadline : stop.deadline + grace);
  const auto certificate = told ? static_cast<Certificate>(told->front()) : Certificate::not_shown;
  if (certificate == Certificate::refuted && !may_be_refuted)
    throw std::logic_error("the solver refutes the minimal models");
  return certificate == Certificate::shown;
}

}  // namespace asterism
