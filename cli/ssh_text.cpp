#include "cli/ssh_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <vector>

#include "cli/map_text.hpp"

namespace asterism {
namespace {

/// "1 map", "2 maps".
std::string counted(std::uint64_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

template <class Numbers>
std::string list(const char* noun, const Numbers& numbers) {
  return fmt::format("{}{} {}", noun, numbers.size() == 1 ? "" : "s", fmt::join(numbers, ", "));
}

std::string text(const SshMap::Along& along) {
  const char* const sign = along.direction == SshMap::Direction::forward    ? "+"
                           : along.direction == SshMap::Direction::backward ? "-"
                                                                            : "+-";
  return fmt::format("path {}{}", along.path.index(), sign);
}

std::string map_text(const SshMap& map, const Experience& experience) {
  std::string result;
  for (std::size_t d = 0; d < map.places.size(); ++d) {
    std::vector<std::size_t> views;
    for (std::size_t k = 0; k < map.dstates.size(); ++k)
      if (map.dstates[k].index() == d) views.push_back(k);
    result += fmt::format("  dstate {}: {}, \"{}\"; place {}, {}\n", d, list("view", views),
                          printable(experience.views[views.front()]), map.places[d].index(),
                          text(map.paths[d]));
  }
  for (std::size_t place = 0; place < map.number_of_places(); ++place) {
    std::vector<std::size_t> dstates;
    for (std::size_t d = 0; d < map.places.size(); ++d)
      if (map.places[d].index() == place) dstates.push_back(d);
    result += fmt::format("  place {}: {}\n", place, list("dstate", dstates));
  }
  for (std::size_t path = 0; path < map.number_of_paths(); ++path) {
    std::set<std::size_t> places;
    for (std::size_t d = 0; d < map.places.size(); ++d)
      if (map.paths[d].path.index() == path) places.insert(map.places[d].index());
    result += fmt::format("  path {}: {}\n", path, list("place", places));
  }
  const std::size_t robot = map.dstates.back().index();
  return result + fmt::format("  {}; the robot is at place {}, along {}\n",
                              counted(map.segments.size(), "segment"), map.places[robot].index(),
                              text(map.paths[robot]));
}

}  // namespace

std::string report_text(const SshReport& report, std::size_t most_maps) {
  const std::string planar = report.options.planar ? "planar " : "";
  const std::size_t views = report.experience.views.size();
  std::string text = fmt::format("{}: {}, {}\n", printable(report.experience.name),
                                 counted(views, "view"), counted(views - 1, "action"));
  text += method_text(report.options);
  if (report.per_view)
    text += fmt::format("{}maps after each view: {}\n", planar, fmt::join(*report.per_view, " "));
  if (!report.complete) {
    text += fmt::format("stopped by {}", report.stopped_by.value_or("a limit"));
    const std::size_t explained = report.per_view ? report.per_view->size() : 0;
    text += explained < views ? fmt::format(" before view {} was explained\n", explained) : "\n";
  }
  if (report.consistent)
    text += *report.consistent == 0
                ? fmt::format("no {}map explains the trace\n", planar)
                : fmt::format("{} {} the trace\n", counted(*report.consistent, planar + "map"),
                              *report.consistent == 1 ? "explains" : "explain");
  if (report.minimal) text += minimal_text(*report.minimal, report.options);
  for (std::size_t i = 0; i < std::min(report.maps.size(), most_maps); ++i)
    text += fmt::format("\n{} {}\n", report.options.all ? "map" : "model", i) +
            map_text(report.maps[i], report.experience);
  const std::size_t all = report.options.all ? report.consistent.value_or(0) : report.maps.size();
  if (all > most_maps) text += fmt::format("\n({} more: see --json)\n", all - most_maps);
  return text;
}

}  // namespace asterism
