#include "io/json/map_json.hpp"

#include <map>
#include <optional>
#include <utility>

namespace asterism {
namespace {

using Arms = std::vector<std::optional<std::size_t>>;

std::vector<TopologicalMap::Place> read_places(const JsonNode& node) {
  std::vector<TopologicalMap::Place> result;
  for (const JsonNode& place : node.items()) {
    place.require_keys({"star", "first_visit"});
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

/// Arms of the visits' places, all with gateways.
/// @param may_be_absent  at this visit one may be null; everywhere, if this is nothing
Arms read_arms(const JsonNode& node, const TopologicalMap& map,
               std::optional<std::size_t> may_be_absent) {
  Arms result;
  const auto items = node.items(map.visits.size(), "arms, one a visit");
  for (std::size_t k = 0; k < items.size(); ++k) {
    if (may_be_absent.value_or(k) == k && items[k].is_null()) {
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
    if (map.left[k].has_value() != map.entered[k + 1].has_value())
      (map.left[k] ? entered : left)
          .items()[k + (map.left[k] ? 1 : 0)]
          .refuse("null", "an arm, or null for the other end of the travel, too");
    if (!map.left[k]) continue;  // it is cut there
    const PlaceArm from{map.visits[k], *map.left[k]};
    const PlaceArm to{map.visits[k + 1], *map.entered[k + 1]};
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

void write_json(JsonWriter& json, PlaceArm arm) { json.value(std::pair(arm.place, arm.arm)); }

void write_arrivals(JsonWriter& json, std::span<const std::optional<Arrival>> arrivals) {
  json.object([&] {
    json.key("visits").list(arrivals, [](JsonWriter& to, const std::optional<Arrival>& arrival) {
      arrival ? to.value(arrival->place) : to.null();
    });
    json.key("entered").list(arrivals, [](JsonWriter& to, const std::optional<Arrival>& arrival) {
      arrival ? to.value(arrival->entered) : to.null();
    });
  });
}

void write_arrivals(JsonWriter& json, const std::optional<std::vector<Arrival>>& arrivals) {
  if (!arrivals) return json.null();
  write_arrivals(json, std::vector<std::optional<Arrival>>(arrivals->begin(), arrivals->end()));
}

void write_map_parts(JsonWriter& json, const TopologicalMap& map) {
  json.member("visits", map.visits);
  json.line().member("entered", map.entered);
  json.line().member("left", map.left);
  json.line().key("places").list(map.places, [](JsonWriter& to, const auto& place) {
    to.tight().object("star", place.star, "first_visit", place.first_visit);
  });
  json.line().key("paths").list(map.paths, [](JsonWriter& to, const auto& path) {
    to.tight().object("places", path.places, "ends", path.ends);
  });
  json.line().member("segments", map.segments);
}

void write_map(JsonWriter& json, const TopologicalMap& map) {
  json.object([&] { write_map_parts(json, map); });
}

TopologicalMap read_map(const JsonNode& node) {
  node.require_keys({"visits", "entered", "left", "places", "paths", "segments"});
  return read_map_parts(node, false);
}

TopologicalMap read_map_parts(const JsonNode& node, bool may_be_in_pieces) {
  TopologicalMap map;
  map.places = read_places(node["places"]);
  map.visits = read_visits(node["visits"], node["places"], map.places);
  const auto absent_at = [&](std::size_t visit) {
    return may_be_in_pieces ? std::nullopt : std::optional(visit);
  };
  map.entered = read_arms(node["entered"], map, absent_at(0));
  map.left = read_arms(node["left"], map, absent_at(map.visits.size() - 1));
  require_matching(map, node["entered"], node["left"]);

  map = make_map(trace_of(map), arrivals(map));
  const auto paths = implied(node["paths"], map.paths.size());
  for (std::size_t i = 0; i < paths.size(); ++i) {
    paths[i].require_keys({"places", "ends"});
    paths[i]["places"].require_implied(json_of(map.paths[i].places));
    paths[i]["ends"].require_implied(json_of(map.paths[i].ends));
  }
  const auto segments = implied(node["segments"], map.segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i)
    segments[i].require_implied(json_of(map.segments[i]));
  return map;
}

}  // namespace asterism
