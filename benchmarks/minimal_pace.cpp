#include "benchmarks/minimal_pace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "benchmarks/measure.hpp"
#include "engine/minimal/minimal_search.hpp"

namespace asterism {
namespace {

struct Aim {
  std::size_t side;
  TheoryRecord theory;
  double most_s;
};
const std::array aims{Aim{4, {}, 0.01}, Aim{5, {}, 1}, Aim{6, {.planar = true}, 60}};

bool is_met(const Aim& aim, const MinimalRuns& runs) {
  return std::ranges::all_of(runs.results(), [&](const MinimalResult& result) {
    return result.is_proved && result.seconds < aim.most_s;
  });
}

double median_of(std::vector<double> values) {
  std::ranges::sort(values);
  return values.at(values.size() / 2);
}

/// How many times as long as the search clingo takes for the same walk, the median; at least so
/// many if it did not end.
std::string clingo_text(const GrowthRow& row) {
  std::vector<std::pair<double, bool>> ratios;
  for (std::size_t i = 0; i < row.clingo.results().size(); ++i) {
    const MinimalResult& clingo = row.clingo.results()[i];
    ratios.emplace_back(clingo.seconds / row.search.results().at(i).seconds, !clingo.is_proved);
  }
  if (ratios.empty()) return "";
  std::ranges::sort(ratios);
  const auto& [ratio, is_open] = ratios[ratios.size() / 2];
  return (is_open ? "> " : "") + ratio_text(ratio);
}

/// A walk that was searched before.
struct Searched {
  const GrowthRow* row;
  std::uint64_t seed;
  double seconds;
};

std::vector<Searched> longest_proved(std::span<const GrowthRow> rows, std::size_t side,
                                     std::size_t most) {
  std::vector<Searched> walks;
  for (const GrowthRow& row : rows)
    for (std::size_t i = 0; i < row.search.results().size(); ++i)
      if (const MinimalResult& result = row.search.results()[i];
          row.walk.size == side && result.is_proved)
        walks.push_back({&row, i + 1, result.seconds});
  std::ranges::sort(walks, std::greater(), &Searched::seconds);
  if (walks.size() > most)
    walks.erase(walks.begin() + static_cast<std::ptrdiff_t>(most), walks.end());
  return walks;
}

/// Whole searches of one trace with several numbers of threads, in turn, so that what else the
/// machine does is the same for all.
struct ThreadTimes {
  static constexpr std::array<unsigned, 3> jobs{1, 2, 4};
  std::array<std::vector<double>, jobs.size()> seconds;
  bool same = true;  ///< the models are

  ThreadTimes(const Trace& trace, bool planar, const MinimalScale& scale) {
    constexpr std::size_t fewest_rounds = 3;
    const Stopwatch all;
    std::optional<std::vector<std::vector<Arrival>>> models;
    for (std::size_t round = 0; round < scale.rounds; ++round) {
      if (round >= fewest_rounds && all.seconds() > scale.threads_s) break;
      for (std::size_t i = 0; i < jobs.size(); ++i) {
        const Stopwatch stopwatch;
        MinimalSearch search({.theory = {.planar = planar}, .jobs = jobs[i]});
        search.extend(trace.visits);
        search.run();
        seconds[i].push_back(stopwatch.seconds());
        if (!models) models = search.models();
        same = same && search.models() == *models;
      }
    }
  }

  std::string time_text(std::size_t i) const { return duration_text(median_of(seconds[i])); }
  /// How many times as fast as one thread, the median of the rounds.
  std::string gain_text(std::size_t i) const {
    std::vector<double> gains;
    for (std::size_t round = 0; round < seconds[i].size(); ++round)
      gains.push_back(seconds[0][round] / seconds[i][round]);
    return fmt::format("{:.2f} ×", median_of(gains));
  }
};

/// Searches after each visit; ends at the limit.
struct Extending {
  double all_s = 0;
  double longest_s = 0;
  bool is_over = true;
  std::vector<MinimalResult::Size> sizes;
  std::vector<std::uint64_t> counts;

  Extending(const Trace& trace, bool planar, bool afresh, double limit_s) {
    MinimalSearch search({.planar = planar});
    for (std::size_t k = 0; k < trace.visits.size() && is_over; ++k) {
      const Stopwatch stopwatch;
      if (afresh) {
        search = MinimalSearch({.planar = planar});
        search.extend(std::span(trace.visits).first(k + 1));
      } else {
        search.extend(trace.visits[k]);
      }
      const auto outcome = search.run(Stop{}.within(limit_s - all_s));
      is_over = outcome == MinimalSearch::Outcome::complete;
      all_s += stopwatch.seconds();
      longest_s = std::max(longest_s, stopwatch.seconds());
      if (!is_over) break;
      const MinimalSearch::Bounds bounds = search.bounds();
      sizes.push_back({bounds.best->paths, bounds.best->places});
      counts.push_back(bounds.count);
    }
  }

  std::vector<std::string> cells() const {
    const std::string all = duration_text(all_s);
    if (!is_over) return {fmt::format("at visit {} in {}", sizes.size(), all), ""};
    return {all, duration_text(longest_s)};
  }
  /// As far as both came.
  bool agrees(const Extending& other) const {
    const std::size_t common = std::min(sizes.size(), other.sizes.size());
    return std::equal(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(common),
                      other.sizes.begin()) &&
           std::equal(counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(common),
                      other.counts.begin());
  }
};

}  // namespace

void add_aims_table(Report& report, std::span<const GrowthRow> grids) {
  report.begin_table("Minimal models of a grid, and how many times as long clingo takes:",
                     {"walk", "proved", "median", "longest", "aim", "met", "clingo"});
  for (const Aim& aim : aims)
    for (const GrowthRow& row : grids) {
      if (row.walk.size != aim.side || row.theory != aim.theory) continue;
      const MinimalRuns& runs = row.search;
      report.add_row({name_of(row), fmt::format("{} of {}", runs.proved(), runs.results().size()),
                      duration_text(runs.median().seconds), duration_text(runs.slowest().seconds),
                      duration_text(aim.most_s), is_met(aim, runs) ? "yes" : "no",
                      clingo_text(row)});
    }
}

void add_threads_table(Report& report, const MinimalScale& scale,
                       std::span<const GrowthRow> grids) {
  constexpr std::size_t most_walks = 2;
  constexpr std::size_t most_side = 6;
  std::size_t side = 0;
  for (const GrowthRow& row : grids)
    if (row.walk.size <= most_side) side = std::max(side, row.walk.size);
  report.begin_table("Threads, on the walks that took longest, medians:",
                     {"walk", "one thread", "two", "gain", "four", "gain"});
  for (const Searched& searched : longest_proved(grids, side, most_walks)) {
    const Trace trace = make_trace(searched.row->walk, searched.seed);
    const bool planar = searched.row->theory.planar;
    const std::string name =
        fmt::format("{}, seed {}{}", trace.name, searched.seed, planar ? ", planar" : "");
    const ThreadTimes times(trace, planar, scale);
    report.require(times.same, name + ": the number of threads changes the minimal models");
    report.add_row({name, times.time_text(0), times.time_text(1), times.gain_text(1),
                    times.time_text(2), times.gain_text(2)});
  }
}

void add_extending_table(Report& report, const MinimalScale& scale) {
  report.begin_table("Minimal models after every visit: the search extended, and begun again:",
                     {"walk", "extended, all visits", "longest visit", "begun again, all visits",
                      "longest visit"});
  constexpr std::array<GrowingWalk, 2> walks{grid_walks[2], grid_walks[3]};
  for (std::size_t i = 0; i < std::min(scale.extended_walks, walks.size()); ++i)
    for (const bool planar : {false, true}) {
      const Trace trace = make_trace(walks[i], 1);
      const std::string name = trace.name + (planar ? ", planar" : "");
      const Extending extended(trace, planar, false, scale.extending_s);
      const Extending afresh(trace, planar, true, scale.extending_s);
      report.require(extended.agrees(afresh), name + ": extended, the minimal models are others");
      std::vector<std::string> cells{name};
      for (const Extending* one : {&extended, &afresh})
        for (const std::string& cell : one->cells()) cells.push_back(cell);
      report.add_row(cells);
    }
}

}  // namespace asterism
