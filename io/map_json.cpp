#include "io/map_json.hpp"

#include <algorithm>
#include <map>
#include <ostream>
#include <stdexcept>

namespace asterism {
namespace {

using Extensions = JsonNode::Extensions;
using Arms = std::vector<std::optional<std::size_t>>;

std::string json_of(PlaceId place) { return std::to_string(place.index()); }

std::string json_of(const std::optional<std::size_t>& arm) {
  return arm ? std::to_string(*arm) : "null";
}

std::string json_of(const PlaceArm& arm) {
  return '[' + json_of(arm.place) + ", " + std::to_string(arm.arm) + ']';
}

std::string json_of(const TopologicalMap::Segment& segment) {
  return '[' + json_of(segment.first) + ", " + json_of(segment.second) + ']';
}

std::string json_of(const TopologicalMap::Place& place) {
  return "{\"star\": " + json_quoted(place.star.text()) +
         ", \"first_visit\": " + std::to_string(place.first_visit.index()) + '}';
}

template <class Part>
std::string json_of(const std::vector<Part>& parts);

std::string json_of(const TopologicalMap::Path& path) {
  return "{\"places\": " + json_of(path.places) + ", \"ends\": " + json_of(path.ends) + '}';
}

template <class Part>
std::string json_of(const std::vector<Part>& parts) {
  std::string result = "[";
  for (std::size_t i = 0; i < parts.size(); ++i) result += (i == 0 ? "" : ", ") + json_of(parts[i]);
  return result + ']';
}

std::vector<TopologicalMap::Place> read_places(const JsonNode& node) {
  std::vector<TopologicalMap::Place> result;
  for (const JsonNode& place : node.items()) {
    place.require_keys({"star", "first_visit"}, Extensions::refused);
    result.push_back({place["star"].star(), VisitId(place["first_visit"].count())});
  }
  return result;
}

/// Places of the visits, numbered as they were first visited, each of them visited.
std::vector<PlaceId> read_visits(const JsonNode& node, const JsonNode& places_node,
                                 const std::vector<TopologicalMap::Place>& places) {
  std::vector<PlaceId> result;
  std::size_t known = 0;
  for (const JsonNode& item : node.items()) {
    const PlaceId place(item.count());
    if (place.index() > known) item.refuse("at most " + std::to_string(known) + ", the next place");
    if (place.index() == known) {
      if (known == places.size()) item.refuse("one of " + std::to_string(known) + " places");
      if (places[known].first_visit.index() != result.size())
        places_node.items()[known]["first_visit"].refuse(std::to_string(result.size()));
      ++known;
    }
    result.push_back(place);
  }
  if (result.empty()) node.refuse("an empty array", "at least one visit");
  if (known < places.size())
    places_node.refuse("an array of " + std::to_string(places.size()),
                       "the " + std::to_string(known) + " places visited");
  return result;
}

/// Arms of the visits' places, all with gateways; null at most at visit `may_be_absent`.
Arms read_arms(const JsonNode& node, const TopologicalMap& map, std::size_t may_be_absent) {
  Arms result;
  const auto items = node.items(map.visits.size(), "arms, one a visit");
  for (std::size_t k = 0; k < items.size(); ++k) {
    if (k == may_be_absent && items[k].is_null()) {
      result.push_back(std::nullopt);
      continue;
    }
    const Star& star = map.places[map.visits[k].index()].star;
    const std::size_t arm = items[k].count(star.size() - 1);
    if (!star.has_gateway(arm)) items[k].refuse("an arm with α = 1");
    result.push_back(arm);
  }
  return result;
}

/// Each gateway leads to one other. Complains where a travel says otherwise.
void require_matching(const TopologicalMap& map, const JsonNode& entered, const JsonNode& left) {
  std::map<PlaceArm, PlaceArm> other_end;
  const auto join = [&](PlaceArm from, PlaceArm to, const JsonNode& arms, std::size_t visit) {
    const auto [known, is_new] = other_end.emplace(from, to);
    if (!is_new && known->second != to)
      arms.items()[visit].refuse("a travel from " + json_of(from) + " to " + json_of(to),
                                 "one to " + json_of(known->second) + " as before");
  };
  for (std::size_t k = 0; k + 1 < map.visits.size(); ++k) {
    const PlaceArm from{map.visits[k], map.left[k].value()};
    const PlaceArm to{map.visits[k + 1], map.entered[k + 1].value()};
    join(from, to, entered, k + 1);
    join(to, from, left, k);
  }
}

/// The elements of an array that follows from the visits, as many as there must be.
std::vector<JsonNode> implied(const JsonNode& node, std::size_t size) {
  const auto items = node.items();
  if (items.size() != size)
    node.refuse("an array of " + std::to_string(items.size()), std::to_string(size));
  return items;
}

void require_same(const JsonNode& node, const std::string& expected) {
  constexpr std::size_t max_shown = 80;
  if (!node.exists() || node.text() != expected)
    node.refuse(node.exists() ? printable(node.text(), max_shown) : node.found(),
                printable(expected, max_shown));
}

/// A trace that this map explains, by its own stars.
Trace trace_of(const TopologicalMap& map) {
  Trace trace;
  for (std::size_t k = 0; k < map.visits.size(); ++k)
    trace.visits.push_back({.star = map.places[map.visits[k].index()].star,
                            .entered_by = map.entered[k],
                            .left_by = map.left[k]});
  return trace;
}

}  // namespace

void write_map(std::ostream& out, const TopologicalMap& map, std::span<const std::string> more) {
  out << "    { \"visits\": " << json_of(map.visits)
      << ",\n      \"entered\": " << json_of(map.entered)
      << ",\n      \"left\": " << json_of(map.left)
      << ",\n      \"places\": " << json_of(map.places)
      << ",\n      \"paths\": " << json_of(map.paths)
      << ",\n      \"segments\": " << json_of(map.segments);
  for (const std::string& part : more) out << ",\n      " << part;
  out << " }";
}

TopologicalMap read_map(const JsonNode& node) {
  node.require_keys({"visits", "entered", "left", "places", "paths", "segments"},
                    Extensions::refused);
  return read_map_parts(node);
}

TopologicalMap read_map_parts(const JsonNode& node) {
  TopologicalMap map;
  map.places = read_places(node["places"]);
  map.visits = read_visits(node["visits"], node["places"], map.places);
  map.entered = read_arms(node["entered"], map, 0);
  map.left = read_arms(node["left"], map, map.visits.size() - 1);
  require_matching(map, node["entered"], node["left"]);

  map = make_map(trace_of(map), arrivals(map));
  const auto paths = implied(node["paths"], map.paths.size());
  for (std::size_t i = 0; i < paths.size(); ++i) {
    paths[i].require_keys({"places", "ends"}, Extensions::refused);
    require_same(paths[i]["places"], json_of(map.paths[i].places));
    require_same(paths[i]["ends"], json_of(map.paths[i].ends));
  }
  const auto segments = implied(node["segments"], map.segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i)
    require_same(segments[i], json_of(map.segments[i]));
  return map;
}

}  // namespace asterism
