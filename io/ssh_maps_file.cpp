#include "io/ssh_maps_file.hpp"

#include <algorithm>
#include <ostream>
#include <utility>

#include "core/error.hpp"
#include "io/experience_json.hpp"
#include "io/json_node.hpp"
#include "io/report_json.hpp"
#include "io/text_file.hpp"

namespace asterism {
namespace {

using Extensions = JsonNode::Extensions;
using Direction = SshMap::Direction;

template <class Tag>
std::string json_of(Id<Tag> id) {
  return std::to_string(id.index());
}

std::string json_of(const SshMap::Along& along) {
  const char* const sign = along.direction == Direction::forward    ? "+"
                           : along.direction == Direction::backward ? "-"
                                                                    : "+-";
  return '[' + json_of(along.path) + ", \"" + sign + "\"]";
}

std::string json_of(const SshMap::Segment& segment) {
  return '[' + json_of(segment.first) + ", " + json_of(segment.second) + ']';
}

template <class Part>
std::string json_of(const std::vector<Part>& parts) {
  std::string result = "[";
  for (std::size_t i = 0; i < parts.size(); ++i) result += (i == 0 ? "" : ", ") + json_of(parts[i]);
  return result + ']';
}

void write_map(std::ostream& out, const SshMap& map) {
  out << "    { \"dstates\": " << json_of(map.dstates)
      << ",\n      \"places\": " << json_of(map.places)
      << ",\n      \"paths\": " << json_of(map.paths)
      << ",\n      \"segments\": " << json_of(map.segments) << " }";
}

std::vector<DStateId> read_dstates(const JsonNode& node, std::size_t views) {
  std::vector<DStateId> result;
  std::size_t known = 0;
  for (const JsonNode& item : node.items(views, "dstates, one a view")) {
    const DStateId dstate(item.count());
    if (dstate.index() > known)
      item.refuse("at most " + std::to_string(known) + ", the next dstate");
    if (dstate.index() == known) ++known;
    result.push_back(dstate);
  }
  return result;
}

void require_same(const JsonNode& node, const std::string& expected) {
  constexpr std::size_t max_shown = 80;
  if (!node.exists() || node.text() != expected)
    node.refuse(node.exists() ? printable(node.text(), max_shown) : node.found(),
                printable(expected, max_shown));
}

SshMap read_map(const JsonNode& node, const Experience& experience) {
  node.require_keys({"dstates", "places", "paths", "segments"}, Extensions::refused);
  SshMap map = make_ssh_map(experience, read_dstates(node["dstates"], experience.views.size()));
  require_same(node["places"], json_of(map.places));
  require_same(node["paths"], json_of(map.paths));
  require_same(node["segments"], json_of(map.segments));
  return map;
}

std::vector<SshMap> read_sorted_maps(const JsonNode& node, const Experience& experience) {
  std::vector<SshMap> maps;
  for (const JsonNode& item : node.items()) {
    maps.push_back(read_map(item, experience));
    if (maps.size() > 1 && maps.back().dstates <= maps[maps.size() - 2].dstates)
      item.refuse("a map not after the one before", "maps sorted by dstates");
  }
  return maps;
}

std::string number_of_maps(std::uint64_t number) {
  return std::to_string(number) + (number == 1 ? " map" : " maps");
}

/// What is to be minimised, most important first.   @pre tells_minimal(options)
std::vector<std::size_t> extents(const MapOptions& options, std::size_t paths, std::size_t places) {
  std::vector<std::size_t> result;
  for (const std::string& predicate : options.preference)
    result.push_back(predicate == "path" ? paths : places);
  return result;
}

/// Nothing but paths and places is minimised: of other predicates a map does not tell.
bool tells_minimal(const MapOptions& options) {
  return std::ranges::all_of(options.preference, [](const std::string& predicate) {
    return predicate == "path" || predicate == "place";
  });
}

/// All counts are those of the same maps.
void require_counts(const JsonNode& root, const SshReport& report) {
  const std::size_t views = report.experience.views.size();
  if (report.per_view && (report.complete || report.consistent ? report.per_view->size() != views
                                                               : report.per_view->size() > views))
    root["per_view"].refuse("an array of " + std::to_string(report.per_view->size()),
                            std::to_string(views) + ", one a view");
  if (report.consistent && report.per_view && *report.consistent != report.per_view->back())
    root["consistent"].refuse(std::to_string(report.per_view->back()) + ", the last of per_view");
  if (report.complete && report.consistent &&
      (*report.consistent > 0) != report.minimal.has_value())
    root["minimal"].refuse(report.minimal ? "null, since no map is consistent"
                                          : "an object, since a map is consistent");
  if (report.complete && report.options.all && report.consistent &&
      *report.consistent != report.maps.size())
    root["maps"].refuse(number_of_maps(report.maps.size()), std::to_string(*report.consistent));
  if (!report.minimal && !report.options.all && !report.maps.empty())
    root["maps"].refuse(number_of_maps(report.maps.size()), "none, as minimal is null");
}

/// The maps listed hold as many minimal models as told, and none below them; or only these.
void require_minimal(const JsonNode& root, const SshReport& report) {
  const auto& [paths, places, count, certified] = *report.minimal;
  if (count == 0) root["minimal"]["count"].refuse("at least 1");
  if (!report.options.all && report.maps.size() != count)
    root["maps"].refuse(number_of_maps(report.maps.size()), std::to_string(count));
  if (!tells_minimal(report.options)) return;
  const auto least = extents(report.options, paths, places);
  std::size_t number = 0;
  for (std::size_t i = 0; i < report.maps.size(); ++i) {
    const SshMap& map = report.maps[i];
    const auto these = extents(report.options, map.number_of_paths(), map.number_of_places());
    if (these == least) ++number;
    if (these < least || (!report.options.all && these != least))
      root["maps"].items()[i].refuse(
          std::to_string(map.number_of_paths()) + " paths, " +
              std::to_string(map.number_of_places()) + " places",
          std::to_string(paths) + " and " + std::to_string(places) + " as in minimal");
  }
  if (number != count)
    root["maps"].refuse(number_of_maps(number) + " as in minimal", std::to_string(count));
}

SshReport read_ssh_maps(const JsonNode& root) {
  root.require_keys({"format", "version", "kind", "trace", "options", "experience", "consistent",
                     "per_view", "complete", "stopped_by", "minimal", "maps"},
                    Extensions::refused);
  SshReport report;
  auto [views, actions] = read_steps(root["experience"]);
  report.experience = {root["trace"].string(), std::move(views), std::move(actions)};
  report.options = read_options(root["options"]);
  auto [consistent, per_view, complete, stopped_by] = read_counts(root, "per_view", "a view");
  report.consistent = consistent;
  report.per_view = std::move(per_view);
  report.complete = complete;
  report.stopped_by = std::move(stopped_by);
  report.minimal = read_minimal(root["minimal"]);
  report.maps = read_sorted_maps(root["maps"], report.experience);
  require_counts(root, report);
  if (report.minimal) require_minimal(root, report);
  return report;
}

}  // namespace

void write_maps(std::ostream& out, const SshReport& report, const SshMapSource& maps) {
  out << "{ \"format\": \"asterism/maps\", \"version\": 1, \"kind\": \"ssh\", \"trace\": "
      << json_quoted(report.experience.name) << ",\n  \"options\": " << options_json(report.options)
      << ",\n  \"experience\": " << steps_json(report.experience) << ",\n  "
      << counts_json({report.consistent, report.per_view, report.complete, report.stopped_by},
                     "per_view")
      << ",\n  \"minimal\": " << minimal_json(report.minimal) << ",\n  \"maps\": [";
  bool is_first = true;
  maps([&](const SshMap& map) {
    out << (std::exchange(is_first, false) ? "\n" : ",\n");
    write_map(out, map);
  });
  out << (is_first ? "] }\n" : " ] }\n");
}

void write_maps(std::ostream& out, const SshReport& report) {
  write_maps(out, report, [&](const auto& write) {
    for (const SshMap& map : report.maps) write(map);
  });
}

AnyReport read_any_maps(std::string_view json_text, const std::string& file_name) {
  if (json_text.size() <= max_maps_bytes) {
    const JsonDocument document{file_name, parse_json(json_text, file_name)};
    const JsonNode root(document);
    root["format"].require("\"asterism/maps\"");
    root["version"].require("1");
    if (const JsonNode kind = root["kind"]; kind.exists()) {
      kind.require("\"ssh\"");
      return read_ssh_maps(root);
    }
  }
  return read_maps(json_text, file_name);
}

AnyReport read_any_maps_file(const std::string& file) {
  return read_any_maps(read_text_file(file, max_maps_bytes), file);
}

}  // namespace asterism
