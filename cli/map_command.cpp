#include <algorithm>
#include <filesystem>
#include <numeric>
#include <span>

#include "cli/grow.hpp"
#include "cli/map_minimal.hpp"
#include "cli/map_parts.hpp"
#include "cli/map_results.hpp"
#include "cli/progress.hpp"
#include "cli/ssh_map.hpp"
#include "engine/map_tree.hpp"
#include "io/atomic_file.hpp"
#include "io/chart_svg.hpp"
#include "io/maps_file.hpp"
#include "io/trace_file.hpp"

namespace asterism {
namespace {

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

  /// Held for each hypothesis.
  static std::size_t bytes(std::size_t visits) {
    return 2 * visits * sizeof(std::uint32_t) + sizeof(std::size_t);
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
                    const MapReport& report, std::span<const TopologicalMap> models,
                    const Progress& progress) {
  write_models(command, report, models, models.size());
  const auto own = report.per_visit.value_or(std::vector<std::uint64_t>{});
  MapCommand in_time_left = command;
  in_time_left.options.time_limit_s = progress.seconds_left();
  const auto other = other_counts(in_time_left, axioms, trace);
  write_atomically((std::filesystem::path(*command.svg_folder) / "hypotheses.svg").string(),
                   hypotheses_chart_svg(trace.name, report.options.planar ? other : own,
                                        report.options.planar ? own : other));
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

  if (command.options.method == "search") return map_minimal(command, axioms, trace);
  require_no_checkpoint(command, "a search that lists all maps", "shipped axioms and no --check");

  Progress progress(trace.visits.size(), command.options.time_limit_s,
                    command.options.memory_limit_bytes);
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
  if (command.options.all && report.consistent &&
      !progress.has_room(tree.size() * SortedMaps::bytes(command.visits))) {
    report.stopped_by = "memory limit";
    report.complete = false;
    report.minimal.reset();
    maps = [](const auto&) {};
    report.maps.clear();
  } else if (command.options.all && report.consistent) {
    maps = [sorted = SortedMaps(tree)](const auto& write) { sorted.for_each(write); };
    report.maps.clear();
    maps([&](const TopologicalMap& map) {
      if (report.maps.size() <= most_maps_in_text) report.maps.push_back(map);
    });
  }
  write_report(command, report, maps);
  if (command.svg_folder) write_drawings(command, axioms, trace, report, models, progress);
  write_problems(command, axioms, trace, maps);
  if (!report.complete) return exit_undecided;
  return report.consistent.value_or(0) > 0 ? exit_consistent : exit_inconsistent;
}

}  // namespace asterism
