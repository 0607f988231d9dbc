#include "benchmarks/minimal_methods.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <span>
#include <sstream>
#include <string>

#include "benchmarks/asp_facts.hpp"
#include "benchmarks/measure.hpp"
#include "core/stop.hpp"
#include "engine/minimal/minimal_models.hpp"
#include "engine/minimal/minimal_search.hpp"
#include "engine/proof/map_problem.hpp"
#include "engine/proof/optimum.hpp"
#include "engine/tree/map_tree.hpp"

namespace asterism {
namespace {

/// Beyond its own time limit, in which clingo says how far it came.
constexpr double clingo_grace_s = 10;

MinimalResult::Size size_of(const Extents& extents) { return {extents.paths, extents.places}; }

MinimalResult search_once(const Trace& trace, bool planar, double limit_s) {
  const Stopwatch stopwatch;
  MinimalSearch search({.planar = planar});
  search.extend(trace.visits);
  search.run(Stop{}.within(limit_s));
  const MinimalSearch::Bounds bounds = search.bounds();
  MinimalResult result{.seconds = stopwatch.seconds(),
                       .is_proved = search.is_complete(),
                       .at_least = bounds.at_least};
  if (bounds.best) result.best = size_of(*bounds.best);
  if (result.is_proved) result.count = bounds.count;
  return result;
}

/// What stands behind a key and a colon in what clingo said.
std::optional<std::string> said(const std::string& output, const std::string& key) {
  const std::size_t line = output.find("\n" + key);
  if (line == std::string::npos) return std::nullopt;
  const std::size_t begin = output.find(':', line) + 1;
  return output.substr(begin, output.find('\n', begin) - begin);
}

}  // namespace

MinimalResult search_minimal(const Trace& trace, bool planar, double limit_s) {
  MinimalResult result = search_once(trace, planar, limit_s);
  constexpr double short_s = 0.1;
  constexpr std::size_t runs = 9;
  if (!result.is_proved || result.seconds >= short_s) return result;
  std::array<double, runs> seconds{result.seconds};
  for (std::size_t i = 1; i < runs; ++i) seconds[i] = search_once(trace, planar, limit_s).seconds;
  std::ranges::sort(seconds);
  result.seconds = seconds[runs / 2];
  return result;
}

MinimalResult list_minimal(const Trace& trace, bool planar, const MinimalLimits& limits) {
  const Stopwatch stopwatch;
  MapTree tree({.theory = {.planar = planar}, .max_hypotheses = limits.tree_maps});
  const MapTree::Growth growth = tree.extend(trace.visits, Stop{}.within(limits.tree_s));
  if (growth != MapTree::Growth::complete) return {.seconds = stopwatch.seconds()};
  const std::span<const HypothesisId> minimal = tree.minimal();
  MinimalResult result{.seconds = stopwatch.seconds(), .is_proved = true, .count = minimal.size()};
  if (!minimal.empty()) {
    result.best = size_of(extents_of(tree.map(minimal.front())));
    result.at_least = result.best->paths;
  }
  return result;
}

MinimalResult solve_minimal(const Trace& trace, bool planar, double limit_s) {
  const Theory theory{.planar = planar};
  const Stopwatch stopwatch;
  MapProblem problem(trace, theory, Stop{}.within(limit_s));
  const Optimum optimum = find_optimum(problem, trace, theory.axioms, problem.premises());
  MinimalResult result{.seconds = stopwatch.seconds(),
                       .is_proved = optimum.verdict != Verdict::undecided};
  if (!optimum.extents.empty()) result.best = {optimum.extents.at(0), optimum.extents.at(1)};
  if (result.is_proved && result.best) result.at_least = result.best->paths;
  return result;
}

MinimalResult clingo_minimal(const Trace& trace, double limit_s, const std::string& benchmarks,
                             const ScratchFolder& scratch) {
  const std::string facts = scratch.file("facts.lp");
  std::ofstream(facts) << asp_facts(trace);
  const ProcessResult process =
      run_process({"clingo", "0", "-q", "--opt-mode=optN",
                   "--time-limit=" + std::to_string(static_cast<int>(limit_s)),
                   benchmarks + "/maps.lp", benchmarks + "/minimal.lp", facts},
                  limit_s + clingo_grace_s);
  MinimalResult result{.seconds = std::min(process.wall_s, process.cpu_s)};
  const auto says = [&](const char* words) {
    return process.output.find(words) != std::string::npos;
  };
  result.is_proved = says("OPTIMUM FOUND") && !says("INTERRUPTED") && !says("TIME LIMIT");
  if (const auto best = said(process.output, "Optimization")) {
    result.best.emplace();
    std::istringstream(*best) >> result.best->paths >> result.best->places;
  }
  if (!result.is_proved) return {.seconds = process.wall_s, .best = result.best};
  result.at_least = result.best.value().paths;
  // It leaves the line out where there is one.
  result.count = std::stoull(said(process.output, "  Optimal ").value_or("1"));
  return result;
}

}  // namespace asterism
