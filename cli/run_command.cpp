#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <variant>

#include "cli/asked_maps.hpp"
#include "cli/grow.hpp"
#include "cli/map_parts.hpp"
#include "cli/map_text.hpp"
#include "cli/options.hpp"
#include "cli/perceive_parts.hpp"
#include "cli/result_folder.hpp"
#include "cli/run_files.hpp"
#include "cli/run_text.hpp"
#include "core/error.hpp"
#include "engine/explain.hpp"
#include "io/atomic_file.hpp"
#include "io/map_svg.hpp"
#include "io/maps_file.hpp"
#include "io/run_report.hpp"
#include "io/trace_file.hpp"
#include "metric/alignment.hpp"
#include "metric/global_map.hpp"
#include "metric/ranking.hpp"
#include "metric/refinement.hpp"
#include "metric/trajectory.hpp"
#include "planarity/plane_drawing.hpp"

namespace asterism {
namespace {

namespace fs = std::filesystem;

Pose2 pose(const Displacement& d) { return {d.x_m, d.y_m, d.heading_rad}; }

/// What perception made of a log.
struct Perceived {
  Trace trace;
  std::vector<std::optional<Grid>> place_maps;  ///< of each visit
  std::vector<Scan> scans;
  std::vector<LocalPose> poses;  ///< of each scan
};

Perceived perceive(const RunCommand& command) {
  Perceived result;
  result.trace.name = stem_of(command.log);
  const fs::path map_folder = fs::path(command.folder) / "log.lpm";
  make_folder(map_folder);
  LogReader log(command.log, command.laser);
  ScanDetector detector(command.detector);
  const std::size_t scans = detect(
      log, detector,
      [&](const Scan& scan) {
        result.scans.push_back(scan);
        result.poses.push_back({scan.stamp_s, detector.map_from_robot()});
      },
      [&](DetectedVisit detected) {
        if (detected.place_map)
          detected.visit.lpm =
              write_place_map(map_folder, result.place_maps.size(), *detected.place_map);
        result.place_maps.push_back(std::move(detected.place_map));
        result.trace.visits.push_back(std::move(detected.visit));
      });
  require_visits(result.trace, command.log, scans);
  write_trace_file((fs::path(command.folder) / "log.trace.json").string(), result.trace);
  return result;
}

/// The maps of a trace, or of as much of it as can be explained.
struct Explained {
  Trace trace;  ///< the visits explained
  std::variant<MapTree, MinimalSearch> maps;
  MapReport report;
  std::vector<std::uint64_t> other_per_visit;  ///< under the other view on planarity
  std::string why = {};                        ///< no more could be
};

MapTree tree_of(const MapCommand& command, const AxiomSet& axioms, const Trace& trace) {
  MapTree tree(tree_options(command, axioms));
  tree.extend(trace.visits);
  return tree;
}

MapList minimal_of(const Explained& explained) {
  return std::visit([](const auto& maps) { return minimal_maps(maps); }, explained.maps);
}

/// Why no map of the visits so far explains the next: all of them hold a segment by which the robot
/// left, and that leads where something else is seen, or is assumed.
std::string why_not(const Trace& trace, const TopologicalMap& map, const MapOptions& options) {
  const std::size_t k = map.visits.size();
  const std::string assumed =
      options.assumptions.empty() ? "" : fmt::format(", assuming {}", text_of(options.assumptions));
  const PlaceArm left{map.visits.back(), map.left.back().value()};
  for (const auto& [one, other] : map.segments) {
    if (one != left && other != left) continue;
    const PlaceArm reached = one == left ? other : one;
    const TopologicalMap::Place& place = map.places[reached.place.index()];
    std::vector<Arrival> child = arrivals(map);
    child.push_back({reached.place, reached.arm});
    std::string names;
    const auto reason = explain_dropped(trace, child, AxiomSet::shipped(), options.planar);
    if (!reason && !assumed.empty())
      return fmt::format("visit {} came by the way from place {} to place {}, and was not there{}",
                         k, left.place.index(), reached.place.index(), assumed);
    if (reason)
      for (const std::string& name : reason->axioms) names += (names.empty() ? "" : ", ") + name;
    return fmt::format(
        "visit {} came by the way from place {} to place {}, in by arm {}, where visit {} saw {}; "
        "it saw {}, in by arm {}{}",
        k, left.place.index(), reached.place.index(), place.star.name(reached.arm),
        place.first_visit.index(), place.star.text(), trace.visits[k].star.text(),
        trace.visits[k].star.name(trace.visits[k].entered_by.value()),
        names.empty() ? "" : fmt::format(" (against {})", names));
  }
  return fmt::format("visit {} is at no place, known or new{}", k, assumed);
}

Explained explain(const RunCommand& command, const Trace& trace) {
  MapCommand maps;
  maps.options = command.maps;
  maps.visits = trace.visits.size();
  const AxiomSet axioms = AxiomSet::shipped();
  Progress progress(trace.visits.size(), command.maps.time_limit_s);
  AskedMaps asked(maps, axioms, trace, command.only_minimal, progress);
  std::optional<std::string> stopped_by = asked.find();
  // A search that was stopped may know some maps of the whole trace.
  std::size_t explained = asked.explained_visits();
  if (stopped_by && asked.are_searched() && asked.minimal().size > 0)
    explained = trace.visits.size();
  const bool is_counted = !asked.are_searched();

  Explained result{trace, std::move(asked).take(), {}, {}};
  result.report = std::visit(
      [&](const auto& found) { return report_of(found, maps, axioms, stopped_by, progress); },
      result.maps);
  result.report.trace = trace.name;
  if (is_counted) result.other_per_visit = other_counts(maps, axioms, trace);
  if (explained == trace.visits.size()) return result;
  const std::size_t looked_at = minimal_of(result).trace.visits.size();
  result.trace.visits.erase(result.trace.visits.begin() + static_cast<std::ptrdiff_t>(explained),
                            result.trace.visits.end());
  if (explained < looked_at && is_counted) {
    result.maps = tree_of(maps, axioms, result.trace);
  } else if (explained < looked_at) {
    MinimalSearch part(std::get<MinimalSearch>(result.maps).options());
    part.extend(result.trace.visits);
    part.run([&](const MinimalSearch& now) { return progress.searched(now); });
    if (!part.is_complete()) stopped_by = progress.stopped_by();
    result.report.complete = !stopped_by;
    result.report.stopped_by = stopped_by;
    result.maps = std::move(part);
  }
  if (explained > 0) result.report.explained_visits = explained;
  if (explained == 0 && !stopped_by)
    result.why =
        fmt::format("visit 0 is at no place, assuming {}", text_of(command.maps.assumptions));
  if (stopped_by)
    result.why = fmt::format("{} was stopped: {}", is_counted ? "growing the tree" : "the search",
                             *stopped_by);
  return result;
}

std::vector<RankedMap> rank(const RunCommand& command, const Perceived& perceived,
                            const Explained& explained) {
  PlaceAlignments alignments(explained.trace, perceived.place_maps);
  Ranking ranking(explained.trace, std::ref(alignments), {.models = command.models});
  const auto add = [&](const MapList& list) {
    ranking.add([list](const auto& f) {
      list.for_each_while([&](std::span<const Arrival> map) {
        f(map);
        return true;
      });
    });
  };
  if (command.only_minimal) {
    add(minimal_of(explained));
  } else {
    const auto& tree = std::get<MapTree>(explained.maps);
    for (const auto& hypotheses : tree.by_preference()) {
      ranking.add([&tree, hypotheses](const auto& f) {
        tree.for_each(hypotheses, [&](HypothesisId, std::span<const Arrival> map) { f(map); });
      });
      if (ranking.is_settled()) break;
    }
  }
  std::vector<RankedMap> result = ranking.best();
  // The minimal models stand beside the best, however ill they fit.
  for (RankedMap& minimal : ranking.most_preferred()) {
    const auto is_same = [&](const RankedMap& other) {
      return arrivals(other.map) == arrivals(minimal.map);
    };
    if (std::ranges::none_of(result, is_same)) result.push_back(std::move(minimal));
  }
  return result;
}

/// Where each visit was, by the layout: [x_{i,0}]_{m*} = χ ⊕ L_i. Visits that the map does not
/// explain follow by displacement alone.                              [BMK10, §7.3.3] [DESIGN §12]
std::vector<Anchor> anchors(const Trace& trace, const RankedMap& ranked) {
  std::vector<Pose2> layout_from_visit;
  for (const PlaceId place : ranked.map.visits)
    layout_from_visit.push_back(ranked.layout.layout_from_place[place.index()]);
  for (const Alignment& alignment : ranked.alignments) {
    Pose2& visit = layout_from_visit[alignment.visit.index()];
    visit = visit * alignment.place_from_visit;
  }
  std::vector<Anchor> result;
  for (std::size_t k = 0; k < trace.visits.size(); ++k) {
    if (k == layout_from_visit.size())
      layout_from_visit.push_back(layout_from_visit.back() * pose(*trace.visits[k].displacement));
    result.push_back(
        {static_cast<std::size_t>(trace.visits[k].scans.value()[0]), layout_from_visit[k]});
  }
  return result;
}

DrawnModel draw_model(const RunCommand& command, const Perceived& perceived, RankedMap ranked,
                      Refinement* refinement) {
  DrawnModel model{std::move(ranked)};
  model.trajectory = fit_trajectory(perceived.poses, anchors(perceived.trace, model.ranked));
  if (refinement != nullptr) model.trajectory = (*refinement)(model.trajectory);
  model.global_map =
      global_map(perceived.scans, model.trajectory, {.resolution_m = command.resolution_m});
  return model;
}

Grid odometry_map(const RunCommand& command, const std::vector<Scan>& scans) {
  Trajectory wheels;
  for (const Scan& scan : scans)
    wheels.push_back({scan.stamp_s, inverse(scans.front().odom_from_robot) * scan.odom_from_robot});
  return global_map(scans, wheels, {.resolution_m = command.resolution_m});
}

/// What growing the tree found; the minimal models themselves are for the ranking to show.
std::string counts_text(MapReport report, std::size_t visits) {
  report.maps.clear();
  const std::string text = report_text(report, visits, 0);
  return text.substr(text.find('\n') + 1);  // its first line is told before
}

RunReport report_of(const RunCommand& command, const Perceived& perceived,
                    const Explained& explained, const std::vector<DrawnModel>& models) {
  RunReport page;
  page.log = perceived.trace.name;
  page.scans = perceived.scans.size();
  page.duration_s = perceived.scans.back().stamp_s - perceived.scans.front().stamp_s;
  for (std::size_t i = 1; i < perceived.poses.size(); ++i)
    page.driven_m += norm(perceived.poses[i].map_from_robot.position() -
                          perceived.poses[i - 1].map_from_robot.position());
  page.trace = perceived.trace;
  page.place_maps = perceived.place_maps;
  page.odometry_map = odometry_map(command, perceived.scans);
  page.planar = command.maps.planar;
  page.assumptions = command.maps.assumptions;
  const auto own = explained.report.per_visit.value_or(std::vector<std::uint64_t>{});
  page.all_per_visit = page.planar ? explained.other_per_visit : own;
  page.planar_per_visit = page.planar ? own : explained.other_per_visit;
  page.consistent = explained.report.consistent;
  page.minimal = explained.report.minimal;
  if (explained.trace.visits.size() < perceived.trace.visits.size())
    page.unexplained = {{explained.trace.visits.size(), explained.why}};
  for (const DrawnModel& model : models)
    page.models.push_back(
        {model.ranked, model.global_map, model.trajectory,
         bare_map_svg(model.ranked.map, draw(model.ranked.map), perceived.trace.name)});
  page.decided = decisions(page, minimal_of(explained).size);
  return page;
}

}  // namespace

int run_command(const RunCommand& asked) {
  const auto stated = read_assumptions(asked.assume);
  ResultFolder results(asked.folder);
  const fs::path& folder = results.unfinished();
  RunCommand command = asked;
  command.folder = folder.string();
  const auto tell = [&](const std::string& found) {
    if (!command.json) fmt::print("{}", found);
    std::fflush(stdout);
  };
  StageTimes stage_is_over;

  const Perceived perceived = perceive(command);
  stage_is_over("perceive");
  command.maps.assumptions = assumptions_of(stated, perceived.trace);
  const std::size_t visits = perceived.trace.visits.size();
  tell(fmt::format("{}: {} scans, {} visits\n", printable(perceived.trace.name),
                   perceived.scans.size(), visits));

  Explained explained = explain(command, perceived.trace);
  stage_is_over("grow");
  tell(counts_text(explained.report, visits));

  explained.report.ranked = rank(command, perceived, explained);
  stage_is_over("rank");
  if (explained.report.explained_visits && explained.why.empty())
    explained.why = why_not(perceived.trace, explained.report.ranked.front().map, command.maps);
  if (explained.report.explained_visits && explained.report.complete) tell(explained.why + '\n');
  if (explained.report.explained_visits && !explained.report.ranked.empty())
    tell(fmt::format("ranked: maps of the visits up to {}; later ones are drawn as measured\n",
                     *explained.report.explained_visits - 1));
  write_maps_file((folder / "maps.json").string(), explained.report);

  Refinement refinement(perceived.scans, perceived.poses);
  std::vector<DrawnModel> models;
  for (const RankedMap& ranked : explained.report.ranked) {
    models.push_back(
        draw_model(command, perceived, ranked, models.empty() ? &refinement : nullptr));
    const std::size_t rank = models.size();
    write_model(rank == 1 ? folder : folder / fmt::format("model-{}", rank), models.back());
  }
  const RunReport page = report_of(command, perceived, explained, models);
  write_atomically((folder / "report.html").string(), run_report_html(page));
  results.finish();
  stage_is_over("draw");

  tell(ranking_text(page));
  if (command.json)
    fmt::print("{}", summary_json(page, explained.report.complete));
  else
    fmt::print("results are in {}: look at report.html first\n", asked.folder);
  if (!explained.report.complete) return exit_undecided;
  return page.unexplained ? exit_inconsistent : exit_consistent;
}

}  // namespace asterism
