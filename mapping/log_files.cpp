#include "mapping/log_files.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

#include "drawing/plane_drawing.hpp"
#include "io/atomic_file.hpp"
#include "io/grid/grid_file.hpp"
#include "io/json/maps_file.hpp"
#include "io/json/trace_file.hpp"
#include "io/picture/map_svg.hpp"
#include "mapping/decisions.hpp"
#include "mapping/model_files.hpp"

namespace asterism {
namespace {

/// The trace, with the maps of its places in a folder beside it.
void write_trace(const std::filesystem::path& folder, const Perceived& perceived) {
  Trace trace = perceived.trace;
  const std::filesystem::path map_folder = folder / "log.lpm";
  make_folder(map_folder);
  for (std::size_t k = 0; k < trace.visits.size(); ++k)
    if (const auto& place_map = perceived.place_maps[k])
      trace.visits[k].lpm = write_place_map(map_folder, k, *place_map);
  write_trace_file((folder / "log.trace.json").string(), trace);
}

}  // namespace

RunReport run_report_of(const LogMaps& maps) {
  const auto& [perceived, explained, models, by_wheels, remarks] = maps;
  RunReport page;
  page.log = perceived.trace.name;
  page.scans = perceived.scans.size();
  page.duration_s = perceived.scans.back().stamp_s - perceived.scans.front().stamp_s;
  for (std::size_t i = 1; i < perceived.poses.size(); ++i)
    page.driven_m += norm(perceived.poses[i].map_from_robot.position() -
                          perceived.poses[i - 1].map_from_robot.position());
  page.trace = perceived.trace;
  page.place_maps = perceived.place_maps;
  page.odometry_map = by_wheels;
  page.theory = explained.report.options.theory;
  const auto own = explained.report.per_visit.value_or(std::vector<std::uint64_t>{});
  page.all_per_visit = page.theory.planar ? explained.other_per_visit : own;
  page.planar_per_visit = page.theory.planar ? own : explained.other_per_visit;
  page.consistent = explained.report.consistent;
  page.minimal = explained.report.minimal;
  const std::size_t visits = explained.maps.trace().visits.size();
  if (visits < perceived.trace.visits.size()) page.unexplained = {{visits, explained.why}};
  for (const auto& [ranked, trajectory, drawn, fault] : models)
    page.models.push_back({ranked, drawn, trajectory,
                           bare_map_svg(ranked.map, draw(ranked.map), perceived.trace.name)});
  page.decided = decisions(page, explained.maps.minimal().size);
  page.remarks = remarks;
  return page;
}

void write_log_files(const std::filesystem::path& folder, const LogMaps& maps, RunReport report) {
  write_trace(folder, maps.perceived);
  write_maps_file((folder / "maps.json").string(), maps.explained.report);
  for (std::size_t rank = 1; rank <= maps.models.size(); ++rank) {
    try {
      write_model(rank == 1 ? folder : folder / fmt::format("model-{}", rank),
                  maps.models[rank - 1]);
    } catch (const std::invalid_argument& error) {
      report.remarks.push_back(fmt::format("rank {} is not written whole: {}", rank, error.what()));
    }
  }
  write_atomically((folder / "report.html").string(), run_report_html(report));
}

std::string write_place_map(const std::filesystem::path& folder, std::size_t visit,
                            const Grid& place_map) {
  const std::string name = fmt::format("visit-{}.json", visit);
  write_grid_file((folder / name).string(), place_map);
  return (folder.filename() / name).string();
}

}  // namespace asterism
