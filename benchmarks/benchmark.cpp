#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/explanation_table.hpp"
#include "benchmarks/exploration_table.hpp"
#include "benchmarks/metric.hpp"
#include "benchmarks/minimal_table.hpp"
#include "benchmarks/perception.hpp"
#include "benchmarks/tables.hpp"
#include "benchmarks/traces.hpp"
#include "io/atomic_file.hpp"
#include "tests/support/known_traces.hpp"

namespace asterism {
namespace {

std::vector<KnownCase> shared_cases() {
  std::vector<KnownCase> cases;
  for (const KnownTrace& known : known_traces())
    cases.push_back({known.trace, known.all.consistent, known.planar.consistent});
  return cases;
}

std::vector<KnownCase> simulated_cases(std::uint64_t most_maps) {
  std::vector<KnownCase> cases;
  for (const BenchmarkTrace& benchmark : benchmark_traces)
    if (benchmark.consistent <= most_maps)
      cases.push_back({make_trace(benchmark), benchmark.consistent, std::nullopt});
  return cases;
}

/// ASTERISM_DATA, or where it lies beside the sources.
std::string data_folder() {
  const char* const folder = std::getenv("ASTERISM_DATA");
  return folder ? folder : std::filesystem::path(ASTERISM_SOURCE_DIR).parent_path() / "shared/data";
}

void add_map_tables(Report& report, const Scale& scale, const Programs& programs, bool smoke) {
  const std::vector<KnownCase> shared = shared_cases();
  const auto small = std::ranges::find(shared, "eight-crossings",
                                       [](const KnownCase& known) { return known.trace.name; });
  const std::vector<KnownCase> simulated = simulated_cases(smoke ? 2000 : UINT64_MAX);
  std::vector<KnownCase> listed{*small};
  listed.insert(listed.end(), simulated.begin(), simulated.end());
  add_listing_table(report, scale, programs, listed);
  add_online_table(report, scale, simulated);
  add_solver_table(report, scale, smoke ? std::span(&*small, 1) : std::span(shared));
}

/// Those of which every impossible pair of visits is explained.
std::vector<Trace> explained_traces(bool smoke) {
  std::vector<Trace> traces;
  for (const KnownTrace& known : known_traces())
    for (const char* name : {"eight-crossings", "aces-stubs", "grid-4x4-snake"})
      if (known.trace.name == name) traces.push_back(known.trace);
  if (smoke) {
    traces.erase(traces.begin() + 1, traces.end());
    traces.front().visits.erase(traces.front().visits.begin() + 6, traces.front().visits.end());
  }
  return traces;
}

MinimalScale minimal_scale(bool quick, bool smoke) {
  if (smoke)
    return {.limits = {.search_s = 10, .tree_s = 5, .clingo_s = 10, .solver_s = 10},
            .sizes = 1,
            .seeds = 2,
            .sweep_s = 0.01,
            .extended_walks = 1,
            .rounds = 1};
  if (quick)
    return {.limits = {.search_s = 4, .tree_s = 2, .clingo_s = 5, .solver_s = 2},
            .seeds = 3,
            .sweep_s = 0.5,
            .extending_s = 4,
            .rounds = 3};
  return {};
}

int run(int argc, char** argv) {
  bool explanation = false;
  bool exploration = false;
  bool metric = false;
  bool minimal = false;
  bool perception = false;
  bool quick = false;
  bool smoke = false;
  std::string output;
  std::optional<std::string> picture;
  std::string program = ASTERISM_PROGRAM;
  CLI::App app("Measures Asterism beside other programs; fails where they count otherwise");
  app.add_flag("--quick", quick, "without clingo on the largest trace, and shorter limits");
  app.add_flag("--smoke", smoke, "the smallest traces alone, once: are the counts right?");
  app.add_flag("--explanation", explanation, "explanations alone");
  app.add_flag("--perception", perception, "perception alone, without any count");
  app.add_flag("--exploration", exploration, "exploration alone, without any count");
  app.add_flag("--metric", metric, "the metric level alone, without any count");
  app.add_flag("--minimal", minimal, "the search for minimal models alone");
  app.add_option("--picture", picture, "SVG file to draw the times of that search in");
  app.add_option("--output", output, "Markdown file to write; stdout where not given");
  app.add_option("--asterism", program, "the program to measure")->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 64;
  }

  const Scale scale = smoke
                          ? Scale{.runs = 1, .time_limit_s = 60, .most_clingo = 100, .most_z3 = 100}
                      : quick ? Scale{.most_clingo = 200'000}
                              : Scale{};
  const Programs programs(program, ASTERISM_SOURCE_DIR "/benchmarks");
  Report report;
  const bool all = !explanation && !exploration && !perception && !metric && !minimal;
  const std::size_t most_scans = smoke ? 300 : SIZE_MAX;
  if (all) add_map_tables(report, scale, programs, smoke);
  if (all || minimal)
    add_minimal_tables(report, minimal_scale(quick, smoke), ASTERISM_SOURCE_DIR "/benchmarks",
                       picture);
  if (all || explanation) add_explanation_table(report, explained_traces(smoke));
  if (all || exploration) add_exploration_table(report, smoke ? 2 : 100);
  if (all || perception) add_perception_table(report, perception_cases(data_folder()), most_scans);
  if (all || metric) {
    add_global_map_table(report, perception_cases(data_folder()), most_scans);
    add_layout_table(report, smoke ? 100 : SIZE_MAX);
  }
  output.empty() ? fmt::print("{}", report.markdown())
                 : write_atomically(output, report.markdown());
  return report.counts_agree() ? 0 : 1;
}

}  // namespace
}  // namespace asterism

int main(int argc, char** argv) {
  try {
    return asterism::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "asterism_benchmark: {}\n", error.what());
    return 70;
  }
}
