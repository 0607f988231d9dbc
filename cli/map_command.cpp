#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <numeric>
#include <span>

#include "cli/grow.hpp"
#include "cli/map_parts.hpp"
#include "cli/map_text.hpp"
#include "cli/progress.hpp"
#include "cli/ssh_map.hpp"
#include "engine/map_tree.hpp"
#include "io/atomic_file.hpp"
#include "io/chart_svg.hpp"
#include "io/map_svg.hpp"
#include "io/maps_file.hpp"
#include "io/trace_file.hpp"
#include "planarity/plane_drawing.hpp"

namespace asterism {
namespace {

constexpr std::size_t most_maps_in_text = 20;
constexpr std::size_t most_drawings = 100;

/// All hypotheses in the order of reports, by (visits, entered).                     [DESIGN §9]
class SortedMaps {
 public:
  explicit SortedMaps(const MapTree& tree) : tree_(tree), width_(2 * tree.trace().visits.size()) {
    keys_.reserve(width_ * tree.size());
    tree.for_each([&](HypothesisId, std::span<const Arrival> arrivals) {
      for (const Arrival& arrival : arrivals)
        keys_.push_back(static_cast<std::uint32_t>(arrival.place.index()));
      for (const Arrival& arrival : arrivals)
        keys_.push_back(arrival.entered ? static_cast<std::uint32_t>(*arrival.entered) + 1 : 0);
    });
    order_.resize(tree.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::ranges::sort(order_, [&](std::size_t a, std::size_t b) {
      return std::ranges::lexicographical_compare(key(a), key(b));
    });
  }

  void for_each(const std::function<void(const TopologicalMap&)>& f) const {
    for (const std::size_t i : order_) {
      std::vector<Arrival> arrivals;
      for (std::size_t k = 0; k < width_ / 2; ++k) {
        const std::uint32_t entered = key(i)[width_ / 2 + k];
        arrivals.push_back({PlaceId(key(i)[k]), std::nullopt});
        if (entered > 0) arrivals.back().entered = entered - 1;
      }
      f(make_map(tree_.trace(), arrivals));
    }
  }

 private:
  std::span<const std::uint32_t> key(std::size_t i) const {
    return std::span(keys_).subspan(i * width_, width_);
  }

  const MapTree& tree_;
  std::size_t width_;
  std::vector<std::uint32_t> keys_;
  std::vector<std::size_t> order_;
};

void write_drawings(const MapCommand& command, const AxiomSet& axioms, const Trace& trace,
                    const MapReport& report, std::span<const TopologicalMap> models) {
  const std::filesystem::path folder(*command.svg_folder);
  make_folder(folder);
  const std::size_t drawings = std::min(models.size(), most_drawings);
  for (std::size_t i = 0; i < drawings; ++i)
    write_atomically(
        (folder / fmt::format("model-{}.svg", i)).string(),
        map_svg(models[i], draw(models[i]),
                fmt::format("{}, {}minimal model {} (of {})", trace.name,
                            report.options.planar ? "planar " : "", i, models.size())));
  remove_from(folder, "model-{}.svg", drawings);
  const auto own = report.per_visit.value_or(std::vector<std::uint64_t>{});
  const auto other = other_counts(command, axioms, trace);
  write_atomically((folder / "hypotheses.svg").string(),
                   hypotheses_chart_svg(trace.name, report.options.planar ? other : own,
                                        report.options.planar ? own : other));
  if (drawings < models.size())
    fmt::print(stderr, "drew the first {} of {} minimal models\n", drawings, models.size());
}

}  // namespace

int map_command(const MapCommand& given) {
  MapCommand command = given;
  const auto stated = read_assumptions(command.assume);
  const AnyTrace any = read_any_trace_file(command.trace == "-" ? "/dev/stdin" : command.trace);
  if (const auto* experience = std::get_if<Experience>(&any))
    return map_experience(command, *experience);
  const Trace& trace = std::get<Trace>(any);
  command.options.assumptions = assumptions_of(stated, trace);
  const AxiomSet axioms = read_axioms(command);
  command.visits = trace.visits.size();
  if (!command.why_not.empty()) return why_not(command, axioms, trace);

  Progress progress(trace.visits.size(), command.options.time_limit_s);
  MapTree::Options options = tree_options(command, axioms);
  options.go_on = std::ref(progress);
  MapTree tree(std::move(options));
  std::optional<std::string> stopped_by = grow(tree, trace, command, progress);
  MapReport report = report_of(tree, command, axioms, std::move(stopped_by), progress);
  report.trace = trace.name;
  const std::vector<TopologicalMap> models = report.maps;

  MapSource maps = [&](const auto& write) {
    for (const TopologicalMap& map : models) write(map);
  };
  if (command.options.all && report.consistent) {
    maps = [sorted = SortedMaps(tree)](const auto& write) { sorted.for_each(write); };
    report.maps.clear();
    maps([&](const TopologicalMap& map) {
      if (report.maps.size() <= most_maps_in_text) report.maps.push_back(map);
    });
  }
  if (command.json == "-") {
    write_maps(std::cout, report, maps);
  } else {
    if (command.json)
      write_atomically(*command.json, [&](std::ostream& out) { write_maps(out, report, maps); });
    fmt::print("{}", report_text(report, trace.visits.size(), most_maps_in_text));
  }
  if (command.svg_folder) write_drawings(command, axioms, trace, report, models);
  if (command.smt2_folder) {
    std::size_t i = 0;
    maps([&](const TopologicalMap& map) {
      write_problem(*command.smt2_folder, fmt::format("map-{}.smt2", i++), trace, arrivals(map),
                    axioms);
    });
    remove_from(*command.smt2_folder, "map-{}.smt2", i);
  }
  if (!report.complete) return exit_undecided;
  return report.consistent.value_or(0) > 0 ? exit_consistent : exit_inconsistent;
}

}  // namespace asterism
