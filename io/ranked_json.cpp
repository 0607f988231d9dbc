#include "io/ranked_json.hpp"

#include <array>
#include <ostream>
#include <stdexcept>

#include "io/map_json.hpp"
#include "io/pose_json.hpp"

namespace asterism {
namespace {

using Extensions = JsonNode::Extensions;

std::string misfit_members(const Misfit& misfit) {
  return "\"tail_probability\": " + json_number(misfit.tail_probability) +
         ", \"chi_squared\": " + json_number(misfit.chi_squared) +
         ", \"degrees_of_freedom\": " + std::to_string(misfit.degrees_of_freedom);
}

std::string index_member(const char* key, std::size_t index) {
  return std::string("\"") + key + "\": " + std::to_string(index) + ", ";
}

/// "key": [ one object a line ]
template <class Part, class Members>
std::string list_member(const char* key, const std::vector<Part>& parts, Members members) {
  std::string text = std::string("\"") + key + "\": [";
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "\n        {" : ",\n        {") + members(parts[i]) + '}';
  return text + ']';
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
    item.require_keys({"x_m", "y_m", "heading_rad", "covariance"}, Extensions::refused);
    layout.layout_from_place.push_back(read_pose(item));
    layout.covariances.push_back(read_covariance(item));
  }
  return layout;
}

std::vector<PlaceDisplacement> read_displacements(const JsonNode& node, const TopologicalMap& map) {
  std::vector<PlaceDisplacement> result;
  for (const JsonNode& item : node.items(map.visits.size() - 1, "displacements, one a travel")) {
    item.require_keys({"from", "to", "x_m", "y_m", "heading_rad", "covariance"},
                      Extensions::refused);
    const std::size_t travel = result.size();
    const Pose2 pose = read_pose(item);
    result.push_back({read_place(item["from"], map.visits[travel]),
                      read_place(item["to"], map.visits[travel + 1]),
                      {pose.x_m, pose.y_m, pose.heading_rad, read_covariance(item)}});
  }
  return result;
}

std::vector<Alignment> read_alignments(const JsonNode& node, const TopologicalMap& map) {
  std::vector<Alignment> result;
  for (const JsonNode& item : node.items()) {
    item.require_keys({"visit", "place", "x_m", "y_m", "heading_rad", "covariance", "chi_squared",
                       "degrees_of_freedom", "tail_probability", "matched_walls"},
                      Extensions::refused);
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

}  // namespace

void write_ranked_map(std::ostream& out, const RankedMap& ranked) {
  const auto& poses = ranked.layout.layout_from_place;
  const auto& covariances = ranked.layout.covariances;
  if (poses.size() != ranked.map.places.size() || covariances.size() != poses.size())
    throw std::invalid_argument("layout: found " + std::to_string(poses.size()) + " poses and " +
                                std::to_string(covariances.size()) + " covariances; expected " +
                                std::to_string(ranked.map.places.size()) + " of each");
  const std::array<std::string, 4> parts{
      std::string("\"plausible\": ") + (ranked.is_plausible ? "true" : "false") + ", " +
          misfit_members(ranked.misfit) +
          ", \"log_likelihood\": " + json_number(ranked.log_likelihood),
      list_member("layout", poses,
                  [&](const Pose2& pose) {
                    const auto place = static_cast<std::size_t>(&pose - poses.data());
                    return pose_members(pose, covariances[place]);
                  }),
      list_member("displacements", ranked.displacements,
                  [](const PlaceDisplacement& travel) {
                    const auto& [x_m, y_m, heading_rad, covariance] = travel.displacement;
                    return index_member("from", travel.from.index()) +
                           index_member("to", travel.to.index()) +
                           pose_members({x_m, y_m, heading_rad}, covariance);
                  }),
      list_member("alignments", ranked.alignments, [](const Alignment& alignment) {
        return index_member("visit", alignment.visit.index()) +
               index_member("place", alignment.place.index()) +
               pose_members(alignment.place_from_visit, alignment.covariance) + ", " +
               misfit_members(alignment.misfit) +
               ", \"matched_walls\": " + json_number(alignment.matched_walls);
      })};
  write_map(out, ranked.map, parts);
}

RankedMap read_ranked_map(const JsonNode& node) {
  node.require_keys({"visits", "entered", "left", "places", "paths", "segments", "plausible",
                     "tail_probability", "chi_squared", "degrees_of_freedom", "log_likelihood",
                     "layout", "displacements", "alignments"},
                    Extensions::refused);
  RankedMap ranked{read_map_parts(node)};
  ranked.is_plausible = node["plausible"].boolean();
  ranked.misfit = read_misfit(node);
  ranked.log_likelihood = node["log_likelihood"].number();
  ranked.layout = read_layout(node["layout"], ranked.map.places.size());
  ranked.layout.chi_squared = ranked.misfit.chi_squared;
  ranked.displacements = read_displacements(node["displacements"], ranked.map);
  ranked.alignments = read_alignments(node["alignments"], ranked.map);
  return ranked;
}

}  // namespace asterism
