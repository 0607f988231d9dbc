#include "benchmarks/minimal_growth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <thread>

namespace asterism {
namespace {

constexpr const char* by_search = "this search";
constexpr const char* by_tree = "listing the tree";
constexpr const char* by_clingo = "clingo";
constexpr const char* by_solver = "the solver";

std::string size_text(const MinimalResult::Size& size) {
  return fmt::format("{} paths, {} places", size.paths, size.places);
}

/// What is known where nothing is proved.
std::string bounds_text(const MinimalResult& result) {
  std::string text;
  if (result.at_least) text = fmt::format("paths ≥ {}", *result.at_least);
  if (result.best) text += (text.empty() ? "best " : "; best ") + size_text(*result.best);
  return text;
}

std::string time_text(const MinimalResult& result) {
  return (result.is_proved ? "" : "open after ") + duration_text(result.seconds);
}

std::string median_text(const MinimalRuns& runs) {
  if (runs.results().empty()) return "";
  const MinimalResult median = runs.median();
  return time_text(median) +
         (!median.is_proved && median.best ? ", best " + size_text(*median.best) : "");
}

/// Of the first walk that was left open.
std::string open_text(const MinimalRuns& runs) {
  const auto open = std::ranges::find(runs.results(), false, &MinimalResult::is_proved);
  return open == runs.results().end() ? "" : bounds_text(*open);
}

std::string proved_text(const MinimalRuns& runs) {
  return fmt::format("{} of {}", runs.proved(), runs.results().size());
}

void require_agreement(Report& report, const std::string& name,
                       std::span<const std::pair<std::string, MinimalResult>> said) {
  for (std::size_t i = 0; i < said.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      report.require(agree(said[i].second, said[j].second),
                     fmt::format("{}: {} and {} disagree about the minimal models", name,
                                 said[j].first, said[i].first));
}

std::vector<MinimalMethod> methods(const MinimalScale& scale, bool planar,
                                   const std::string& benchmarks, const ScratchFolder& scratch) {
  const MinimalLimits limits = scale.limits;
  const std::size_t seeds = scale.seeds;
  std::vector<MinimalMethod> all;
  all.emplace_back(
      by_search, MinimalMethod::Patience{.seeds = seeds, .unproved = 1},
      [=](const Trace& trace) { return search_minimal(trace, planar, limits.search_s); });
  all.emplace_back(by_tree, MinimalMethod::Patience{.seeds = seeds},
                   [=](const Trace& trace) { return list_minimal(trace, planar, limits); });
  // What takes a minute each time.
  const std::size_t few_seeds = std::min<std::size_t>(seeds, 3);
  all.emplace_back(by_clingo, MinimalMethod::Patience{.seeds = planar ? 0 : few_seeds},
                   [=, &scratch](const Trace& trace) {
                     return clingo_minimal(trace, limits.clingo_s, benchmarks, scratch);
                   });
  all.emplace_back(by_solver, MinimalMethod::Patience{.seeds = few_seeds}, [=](const Trace& trace) {
    return solve_minimal(trace, planar, limits.solver_s);
  });
  return all;
}

GrowthRow run_size(Report& report, std::vector<MinimalMethod>& methods, const GrowingWalk& walk,
                   bool planar, std::size_t seeds) {
  for (MinimalMethod& method : methods) method.next_size();
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Trace trace = make_trace(walk, seed);
    std::vector<std::pair<std::string, MinimalResult>> said;
    for (MinimalMethod& method : methods)
      if (method.goes_on()) said.emplace_back(method.name(), method.run(trace));
    require_agreement(report, fmt::format("{}, seed {}", trace.name, seed), said);
  }
  return {walk,
          {.planar = planar},
          methods[0].runs(),
          methods[1].runs(),
          methods[2].runs(),
          methods[3].runs()};
}

/// Walks larger than those the search failed at: one seed of each, and two at a time, for it is the
/// bounds that count.
void search_larger(std::vector<GrowthRow>& rows, double limit_s) {
  std::atomic<std::size_t> next = 0;
  const auto search = [&] {
    for (std::size_t i = next++; i < rows.size(); i = next++)
      if (GrowthRow& row = rows[i]; row.search.results().empty())
        row.search.add(search_minimal(make_trace(row.walk, 1), row.theory.planar, limit_s));
  };
  const std::jthread other(search);
  search();
}

TimeRow::Tick tick_of(const GrowingWalk& walk) {
  const std::string size = walk.in == GrowingWalk::In::grid ? fmt::format("{0}×{0}", walk.size)
                                                            : std::to_string(walk.size);
  return {static_cast<double>(walk.travels), std::to_string(walk.travels), size};
}

/// A method's median times, as far as it was tried.
TimeSeries series_of(const std::string& name, MinimalRuns GrowthRow::*runs,
                     std::span<const GrowthRow> rows, bool planar) {
  TimeSeries series{name, {}};
  for (const GrowthRow& row : rows)
    if (row.theory.planar == planar && !(row.*runs).results().empty())
      series.points.push_back((row.*runs).point(row.walk.travels));
  return series;
}

}  // namespace

std::string name_of(const GrowthRow& row) {
  return make_trace(row.walk, 1).name + (row.theory.planar ? ", planar" : "");
}

std::vector<GrowthRow> add_growth_table(Report& report, const MinimalScale& scale,
                                        std::span<const GrowingWalk> walks,
                                        const std::string& benchmarks) {
  report.begin_table(
      fmt::format("The minimal models of walks that grow, median of up to {} seeds:", scale.seeds),
      {"walk", "proved", "this search", "longest", "where it was not proved", by_tree,
       "`clingo --opt-mode=optN`", by_solver});
  const ScratchFolder scratch;
  std::vector<GrowthRow> rows;
  for (const bool planar : {false, true}) {
    std::vector<MinimalMethod> tried = methods(scale, planar, benchmarks, scratch);
    for (const GrowingWalk& walk : walks) {
      rows.push_back(run_size(report, tried, walk, planar, scale.seeds));
      fmt::print(stderr, "  {}: {}\n", name_of(rows.back()), proved_text(rows.back().search));
    }
  }
  search_larger(rows, scale.limits.search_s);
  for (const GrowthRow& row : rows)
    report.add_row({name_of(row), proved_text(row.search), median_text(row.search),
                    time_text(row.search.slowest()), open_text(row.search), median_text(row.tree),
                    median_text(row.clingo), median_text(row.solver)});
  return rows;
}

TimeRow growth_chart(const std::string& title, std::span<const GrowthRow> rows) {
  TimeRow chart{
      .title = title,
      .names = {by_search, by_tree, by_clingo, by_solver},
      .axis = {"travels", rows.front().walk.in == GrowingWalk::In::grid ? "grid" : "corridors"},
      .ticks = {},
      .panels = {}};
  for (const GrowthRow& row : rows)
    if (!row.theory.planar) chart.ticks.push_back(tick_of(row.walk));
  for (const bool planar : {false, true})
    chart.panels[planar ? 1 : 0] = {planar ? "planar maps" : "all maps",
                                    {series_of(by_tree, &GrowthRow::tree, rows, planar),
                                     series_of(by_clingo, &GrowthRow::clingo, rows, planar),
                                     series_of(by_solver, &GrowthRow::solver, rows, planar),
                                     series_of(by_search, &GrowthRow::search, rows, planar)}};
  return chart;
}

TimeRow add_sweep_table(Report& report, const MinimalScale& scale) {
  constexpr std::array<std::size_t, 4> sides{4, 6, 8, 10};
  constexpr std::array<std::size_t, 8> travels{20, 30, 45, 65, 95, 140, 205, 300};
  constexpr std::size_t most_seeds = 3;
  std::vector<std::string> columns{"grid"};
  TimeRow chart{.title = "This search in grids of one size",
                .names = {},
                .axis = {"travels", ""},
                .ticks = {},
                .panels = {}};
  for (const std::size_t count : travels) {
    columns.push_back(fmt::format("{} travels", count));
    chart.ticks.push_back({static_cast<double>(count), std::to_string(count), ""});
  }
  report.begin_table(
      fmt::format("This search on walks that grow in grids that do not, median of {} seeds:",
                  std::min(scale.seeds, most_seeds)),
      columns);
  for (const std::size_t side : sides) chart.names.push_back(fmt::format("{0}×{0}", side));
  for (const bool planar : {false, true}) {
    TimePanel& panel = chart.panels[planar ? 1 : 0];
    panel.title = planar ? "planar maps" : "all maps";
    for (std::size_t i = 0; i < sides.size(); ++i) {
      MinimalMethod search(
          by_search, {.seeds = std::min(scale.seeds, most_seeds), .unproved = 2},
          [&](const Trace& trace) { return search_minimal(trace, planar, scale.sweep_s); });
      TimeSeries series{chart.names[i], {}};
      std::vector<std::string> cells{
          fmt::format("{0} × {0}{1}", sides[i], planar ? ", planar" : "")};
      for (const std::size_t count : travels) {
        search.next_size();
        for (std::uint64_t seed = 1; search.goes_on(); ++seed)
          search.run(make_trace({GrowingWalk::In::grid, sides[i], count}, seed));
        cells.push_back(search.runs().results().empty() ? "" : time_text(search.runs().median()));
        if (!search.runs().results().empty()) series.points.push_back(search.runs().point(count));
      }
      report.add_row(cells);
      panel.series.push_back(series);
    }
  }
  return chart;
}

}  // namespace asterism
