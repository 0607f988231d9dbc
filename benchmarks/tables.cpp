#include "benchmarks/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "benchmarks/measure.hpp"
#include "benchmarks/z3_models.hpp"
#include "engine/minimal/minimal_models.hpp"
#include "engine/proof/certify.hpp"

namespace asterism {
namespace {

/// Its processor time counts, which is less than the wall's on a busy machine: never in our favour.
std::string time_and_ratio(const Listing& listing, double native_s) {
  const std::string time = duration_text(listing.wall_s);
  const std::string ratio = ratio_text(std::min(listing.wall_s, listing.cpu_s) / native_s);
  return listing.maps ? time + ", " + ratio : "not in " + time + ", > " + ratio;
}

Listing list_with_z3(const Trace& trace, double time_limit_s) {
  const Stopwatch stopwatch;
  const ModelCount count = count_models_with_z3(trace, time_limit_s);
  return {count.complete ? std::optional(count.models) : std::nullopt, stopwatch.seconds()};
}

std::string bytes_text(std::optional<double> bytes) {
  return bytes ? fmt::format("{:.1f} B", *bytes) : "";
}

/// One row, of all maps or of the planar ones; `all_s`: a map of all took so long.
double add_online_row(Report& report, const Scale& scale, const KnownCase& known,
                      std::optional<double> all_s) {
  const bool planar = all_s.has_value();
  const std::string name = known.trace.name + (planar ? ", planar" : "");
  const MapTree::Options options{.theory = {.planar = planar}};
  const Listing once = list_with_tree(known.trace, options, scale.runs);
  const OnlineListing online = list_online(known.trace, options, scale.runs);
  const std::optional<std::uint64_t> expected = planar ? known.planar : known.all;
  report.check(name, once.maps, expected.value_or(*once.maps));
  report.check(name + ", visit by visit", online.all.maps, *once.maps);

  const double map_s = once.wall_s / static_cast<double>(*once.maps);
  report.add_row({name, count_text(*once.maps), duration_text(once.wall_s),
                  duration_text(map_s) + (planar ? ", " + ratio_text(map_s / *all_s) : ""),
                  duration_text(online.all.wall_s), duration_text(online.slowest_s),
                  bytes_text(online.tree_bytes_each), bytes_text(online.peak_bytes_each)});
  return map_s;
}

std::string certification_time(const Trace& trace, bool planar) {
  constexpr double time_limit_s = 60;
  MapTree tree({.planar = planar});
  tree.extend(trace.visits);
  const auto models = minimal_models(tree);
  const Stopwatch stopwatch;
  switch (certify(trace, {.planar = planar}, models, Stop{}.within(time_limit_s))) {
    case Certificate::shown:
      return duration_text(stopwatch.seconds());
    case Certificate::not_shown:
      return "not in " + duration_text(time_limit_s);
    case Certificate::refuted:
      break;
  }
  return "refuted";
}

}  // namespace

void add_listing_table(Report& report, const Scale& scale, const Programs& programs,
                       std::span<const KnownCase> cases) {
  const bool has_clingo = programs.has_clingo();
  report.begin_table("Every map of a trace, and how many times as long as the engine others take:",
                     {"trace", "maps", "engine", "`clingo 0 -q`", "`clingo 0 -q --loops=no`",
                      "Z3, models blocked", "`asterism map`, from start to end"});
  for (const auto& [trace, maps, planar] : cases) {
    const Listing native = list_with_tree(trace, {}, scale.runs);
    std::vector<std::string> cells{trace.name, count_text(maps), duration_text(native.wall_s)};
    const auto add = [&, &name = trace.name, maps = maps](const std::string& who,
                                                          const Listing& listing) {
      report.check(name + ", " + who, listing.maps, maps);
      cells.push_back(time_and_ratio(listing, native.wall_s));
    };
    report.check(trace.name, native.maps, maps);
    for (const std::string option : {"", "--loops=no"})
      if (has_clingo && maps <= scale.most_clingo)
        add("clingo", programs.clingo(trace, option, scale.time_limit_s));
      else
        cells.emplace_back();
    if (maps <= scale.most_z3)
      add("Z3", list_with_z3(trace, scale.time_limit_s));
    else
      cells.emplace_back();
    add("asterism map", programs.asterism(trace, scale.runs));
    report.add_row(cells);
  }
}

void add_online_table(Report& report, const Scale& scale, std::span<const KnownCase> cases) {
  report.begin_table(
      "The tree in one pass, and visit by visit as online, with bytes a live hypothesis:",
      {"trace", "maps", "one pass", "a map", "visit by visit", "slowest visit", "tree",
       "peak of the heap"});
  for (const KnownCase& known : cases) {
    const double map_s = add_online_row(report, scale, known, std::nullopt);
    add_online_row(report, scale, known, map_s);
  }
}

void add_solver_table(Report& report, const Scale& scale, std::span<const KnownCase> cases) {
  report.begin_table("Who decides, and how long the solver takes to certify the minimal maps:",
                     {"trace", "maps", "native", "solver", "both", "certified", "planar ones"});
  for (const auto& [trace, maps, planar] : cases) {
    std::vector<std::string> cells{trace.name, count_text(maps)};
    for (const Check check : {Check::native, Check::solver, Check::both}) {
      const std::size_t runs = check == Check::native ? scale.runs : 1;
      const Listing listing = list_with_tree(trace, {.check = check}, runs);
      report.check(trace.name, listing.maps, maps);
      cells.push_back(duration_text(listing.wall_s));
    }
    for (const bool is_planar : {false, true})
      cells.push_back(certification_time(trace, is_planar));
    report.add_row(cells);
  }
}

}  // namespace asterism
