#include "benchmarks/metric.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <optional>

#include "benchmarks/measure.hpp"
#include "benchmarks/pose_graph.hpp"
#include "metric/global_map.hpp"
#include "metric/layout.hpp"
#include "metric/trajectory.hpp"

namespace asterism {
namespace {

constexpr std::size_t timed_runs = 5;
constexpr std::size_t scans_a_visit = 500;  // as on ACES

/// Processor time of what is run, the median.
template <class F>
double processor_s(F&& run) {
  return median(timed_runs, [&] {
    const std::clock_t begin = std::clock();
    run();
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  });
}

struct DrivenScans {
  std::vector<Scan> scans = {};
  std::vector<LocalPose> poses = {};
  std::vector<Anchor> anchors = {};
};

DrivenScans take(const ScanSource& source, std::size_t most_scans) {
  DrivenScans drive;
  while (drive.scans.size() < most_scans) {
    std::optional<Scan> scan = source();
    if (!scan) break;
    if (drive.scans.size() % scans_a_visit == 0)
      drive.anchors.push_back({drive.scans.size(), scan->odom_from_robot});
    drive.poses.push_back({scan->stamp_s, scan->odom_from_robot});
    drive.scans.push_back(*std::move(scan));
  }
  return drive;
}

double root_mean_square_m(const Layout& layout, const PoseGraph& graph) {
  double sum_m2 = 0;
  for (std::size_t i = 0; i < graph.layout_from_place.size(); ++i) {
    const Point2 off =
        layout.layout_from_place[i].position() - graph.layout_from_place[i].position();
    sum_m2 += dot(off, off);
  }
  return std::sqrt(sum_m2 / static_cast<double>(graph.layout_from_place.size()));
}

}  // namespace

void add_global_map_table(Report& report, std::vector<PerceptionCase> cases,
                          std::size_t most_scans) {
  report.begin_table("Trajectory and global map of a drive, in cells of 0.05 m, in processor time:",
                     {"drive", "scans", "trajectory", "cells", "global map", "a scan"});
  for (const auto& [name, source] : cases) {
    if (!source) {
      report.add_row({name, "", "", "", "", ""});
      continue;
    }
    const DrivenScans drive = take(source, most_scans);
    Trajectory trajectory;
    const double trajectory_s =
        processor_s([&] { trajectory = fit_trajectory(drive.poses, drive.anchors); });
    Grid map;
    const double map_s = processor_s([&] { map = global_map(drive.scans, trajectory); });
    report.add_row({name, count_text(drive.scans.size()), duration_text(trajectory_s),
                    count_text(map.log_odds.size()), duration_text(map_s),
                    duration_text(map_s / static_cast<double>(drive.scans.size()))});
  }
}

void add_layout_table(Report& report, std::size_t most_places) {
  report.begin_table("Layout of a grid of places, in processor time:",
                     {"places", "displacements", "with covariances", "without", "from the result",
                      "χ² a degree of freedom", "places off by, the first fixed"});
  for (const std::size_t side : {10U, 32U, 100U}) {
    if (side * side > most_places) break;
    RandomEngine random(1);
    const std::size_t segments = 2 * side * side;
    const PoseGraph graph = grid_pose_graph(side, segments, random);
    const std::size_t places = graph.layout_from_place.size();
    Layout layout;
    const double whole_s = processor_s([&] { layout = lay_out(places, graph.displacements); });
    const double poses_s =
        processor_s([&] { lay_out(places, graph.displacements, {.with_covariances = false}); });
    const double again_s = processor_s([&] {
      lay_out(places, graph.displacements,
              {.start = layout.layout_from_place, .with_covariances = false});
    });
    const auto freedom = static_cast<double>(3 * (segments - (places - 1)));
    report.add_row({count_text(places), count_text(segments), duration_text(whole_s),
                    duration_text(poses_s), duration_text(again_s),
                    fmt::format("{:.3f}", layout.chi_squared / freedom),
                    fmt::format("{:.3f} m", root_mean_square_m(layout, graph))});
  }
}

}  // namespace asterism
