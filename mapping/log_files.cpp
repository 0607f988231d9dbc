#include "mapping/log_files.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "drawing/laid_out_drawing.hpp"
#include "io/atomic_file.hpp"
#include "io/json/maps_file.hpp"
#include "io/picture/map_svg.hpp"
#include "mapping/decisions.hpp"
#include "mapping/kept_perception.hpp"
#include "mapping/model_files.hpp"

namespace asterism {
namespace {

/// The drawing of a map, turned to lie as its layout does.
MapDrawing drawn_as_laid_out(const RankedMap& ranked) {
  std::vector<MapDrawing::Point> places;
  for (const Pose2& pose : ranked.layout.layout_from_place) places.push_back({pose.x_m, pose.y_m});
  return draw_as_laid_out(ranked.map, places);
}

}  // namespace

RunReport run_report_of(LogMaps maps) {
  auto& [perceived, explained, models, by_wheels, remarks] = maps;
  RunReport page;
  page.log = perceived.trace.name;
  page.scans = perceived.scans.size();
  page.duration_s = perceived.scans.back().stamp_s - perceived.scans.front().stamp_s;
  for (std::size_t i = 1; i < perceived.poses.size(); ++i)
    page.driven_m += norm(perceived.poses[i].map_from_robot.position() -
                          perceived.poses[i - 1].map_from_robot.position());
  page.theory = explained.report.options.theory;
  const auto own = explained.report.per_visit.value_or(std::vector<std::uint64_t>{});
  page.all_per_visit = page.theory.planar ? explained.other_per_visit : own;
  page.planar_per_visit = page.theory.planar ? own : explained.other_per_visit;
  page.consistent = explained.report.consistent;
  page.minimal = explained.report.minimal;
  const std::size_t visits = explained.maps.trace().visits.size();
  if (visits < perceived.trace.visits.size()) page.unexplained = {{visits, explained.why}};
  for (auto& [ranked, trajectory, drawn, ways, fault] : models) {
    std::string drawing = bare_map_svg(ranked.map, drawn_as_laid_out(ranked), perceived.trace.name);
    page.models.push_back({std::move(ranked), std::move(drawn), std::move(trajectory),
                           std::move(ways.of_segment), std::move(drawing)});
  }
  page.trace = std::move(perceived.trace);
  page.place_maps = std::move(perceived.place_maps);
  page.odometry_map = std::move(by_wheels);
  page.decided = decisions(page, explained.maps.minimal().size);
  page.remarks = remarks;
  return page;
}

RunReport write_log_files(const std::filesystem::path& folder, LogMaps maps) {
  keep_perceived(folder, maps.perceived);
  write_maps_file((folder / "maps.json").string(), maps.explained.report);
  for (std::size_t rank = 1; rank <= maps.models.size(); ++rank) {
    try {
      write_model(rank == 1 ? folder : folder / fmt::format("model-{}", rank),
                  maps.models[rank - 1]);
    } catch (const std::invalid_argument& error) {
      maps.remarks.push_back(fmt::format("rank {} is not written whole: {}", rank, error.what()));
    }
  }
  RunReport report = run_report_of(std::move(maps));
  write_atomically((folder / "report.html").string(), run_report_html(report));
  return report;
}

}  // namespace asterism
