#include "io/json/ranked_json.hpp"

#include <array>
#include <stdexcept>

#include "io/json/map_json.hpp"
#include "io/json/visit_json.hpp"

namespace asterism {
namespace {

void write_misfit(JsonWriter& json, const Misfit& misfit) {
  json.member("tail_probability", misfit.tail_probability, "chi_squared", misfit.chi_squared,
              "degrees_of_freedom", misfit.degrees_of_freedom);
}

void write_layout(JsonWriter& json, const Layout& layout) {
  json.tight().array([&] {
    for (std::size_t i = 0; i < layout.layout_from_place.size(); ++i)
      json.line().tight().object(
          [&] { write_pose(json, layout.layout_from_place[i], layout.covariances[i]); });
  });
}

void write_travel(JsonWriter& json, const PlaceDisplacement& travel) {
  json.tight().object([&] {
    json.member("from", travel.from, "to", travel.to);
    write_displacement(json, travel.displacement);
  });
}

void write_alignment(JsonWriter& json, const Alignment& alignment) {
  json.tight().object([&] {
    json.member("visit", alignment.visit, "place", alignment.place);
    write_pose(json, alignment.place_from_visit, alignment.covariance);
    write_misfit(json, alignment.misfit);
    json.member("matched_walls", alignment.matched_walls);
  });
}

void write_shared_spot(JsonWriter& json, const SharedSpot& spot) {
  json.tight().object([&] {
    json.member("places", std::array{spot.one, spot.other}, "distance_m", spot.distance_m);
    write_misfit(json, spot.misfit);
  });
}

double read_probability(const JsonNode& node) {
  if (!(node.number() >= 0 && node.number() <= 1)) node.refuse("a number from 0 to 1");
  return node.number();
}

Misfit read_misfit(const JsonNode& object) {
  const JsonNode chi_squared = object["chi_squared"];
  if (chi_squared.number() < 0) chi_squared.refuse("a number, at least 0");
  const Misfit misfit{chi_squared.number(), object["degrees_of_freedom"].count(),
                      read_probability(object["tail_probability"])};
  if (misfit.degrees_of_freedom == 0 && misfit.tail_probability != 1)
    object["tail_probability"].refuse("1, as there are no degrees of freedom");
  return misfit;
}

PlaceId read_place(const JsonNode& node, PlaceId expected) {
  if (node.count() != expected.index()) node.refuse(std::to_string(expected.index()));
  return expected;
}

Layout read_layout(const JsonNode& node, std::size_t places) {
  Layout layout;
  for (const JsonNode& item : node.items(places, "poses, one a place")) {
    item.require_keys({"x_m", "y_m", "heading_rad", "covariance"});
    layout.layout_from_place.push_back(read_pose(item));
    layout.covariances.push_back(read_covariance(item));
  }
  return layout;
}

std::vector<PlaceDisplacement> read_displacements(const JsonNode& node, const TopologicalMap& map) {
  std::vector<PlaceDisplacement> result;
  for (const JsonNode& item : node.items(map.visits.size() - 1, "displacements, one a travel")) {
    item.require_keys({"from", "to", "x_m", "y_m", "heading_rad", "covariance"});
    const std::size_t travel = result.size();
    const Displacement displacement = read_displacement(item);
    result.push_back({read_place(item["from"], map.visits[travel]),
                      read_place(item["to"], map.visits[travel + 1]), displacement});
  }
  return result;
}

std::vector<Alignment> read_alignments(const JsonNode& node, const TopologicalMap& map) {
  std::vector<Alignment> result;
  for (const JsonNode& item : node.items()) {
    item.require_keys({"visit", "place", "x_m", "y_m", "heading_rad", "covariance", "chi_squared",
                       "degrees_of_freedom", "tail_probability", "matched_walls"});
    const VisitId visit(item["visit"].count(map.visits.size() - 1));
    if (!result.empty() && visit <= result.back().visit)
      item["visit"].refuse("a visit after " + std::to_string(result.back().visit.index()));
    const PlaceId place = read_place(item["place"], map.visits[visit.index()]);
    if (map.places[place.index()].first_visit == visit)
      item["visit"].refuse("a return, not the first visit of its place");
    result.push_back({visit, place, read_pose(item), read_covariance(item), read_misfit(item),
                      read_probability(item["matched_walls"])});
  }
  return result;
}

std::vector<SharedSpot> read_shared_spots(const JsonNode& node, std::size_t places) {
  std::vector<SharedSpot> result;
  for (const JsonNode& item : node.items()) {
    item.require_keys(
        {"places", "distance_m", "chi_squared", "degrees_of_freedom", "tail_probability"});
    const auto pair = item["places"].items(2, "places");
    const PlaceId one(pair[0].count(places - 1));
    const PlaceId other(pair[1].count(places - 1));
    if (one >= other) pair[1].refuse("a place after " + std::to_string(one.index()));
    const double distance_m = item["distance_m"].number();
    if (distance_m < 0) item["distance_m"].refuse("metres, at least 0");
    result.push_back({one, other, distance_m, read_misfit(item)});
  }
  return result;
}

}  // namespace

void write_ranked_map(JsonWriter& json, const RankedMap& ranked) {
  const std::size_t poses = ranked.layout.layout_from_place.size();
  const std::size_t covariances = ranked.layout.covariances.size();
  if (poses != ranked.map.places.size() || covariances != poses)
    throw std::invalid_argument("layout: found " + std::to_string(poses) + " poses and " +
                                std::to_string(covariances) + " covariances; expected " +
                                std::to_string(ranked.map.places.size()) + " of each");
  json.object([&] {
    write_map_parts(json, ranked.map);
    json.line().member("plausible", ranked.is_plausible);
    write_misfit(json, ranked.misfit);
    json.member("log_likelihood", ranked.log_likelihood);
    if (!ranked.shared_spots.empty())
      json.line().key("shared_spots").tight().lines(ranked.shared_spots, write_shared_spot);
    write_layout(json.line().key("layout"), ranked.layout);
    json.line().key("displacements").tight().lines(ranked.displacements, write_travel);
    json.line().key("alignments").tight().lines(ranked.alignments, write_alignment);
  });
}

RankedMap read_ranked_map(const JsonNode& node) {
  node.require_keys({"visits", "entered", "left", "places", "paths", "segments", "plausible",
                     "tail_probability", "chi_squared", "degrees_of_freedom", "log_likelihood",
                     "layout", "displacements", "alignments", "shared_spots"});
  RankedMap ranked{read_map_parts(node, true)};
  ranked.is_plausible = node["plausible"].boolean();
  ranked.misfit = read_misfit(node);
  ranked.log_likelihood = node["log_likelihood"].number();
  ranked.layout = read_layout(node["layout"], ranked.map.places.size());
  ranked.layout.chi_squared = ranked.misfit.chi_squared;
  ranked.displacements = read_displacements(node["displacements"], ranked.map);
  ranked.alignments = read_alignments(node["alignments"], ranked.map);
  if (const JsonNode spots = node["shared_spots"]; spots.exists())
    ranked.shared_spots = read_shared_spots(spots, ranked.map.places.size());
  if (ranked.is_plausible && !ranked.shared_spots.empty())
    node["plausible"].refuse("false, as places share a spot");
  return ranked;
}

}  // namespace asterism
