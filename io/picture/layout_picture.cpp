#include "io/picture/layout_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <optional>

#include "io/path_of_arm.hpp"
#include "io/picture/map_legend.hpp"
#include "io/picture/plan_picture.hpp"

namespace asterism {
namespace {

constexpr double margin_m = 3;  ///< round places and the robot's way
constexpr double line_width_px = 4;
constexpr const char* no_path_colour = "#1040c0";

/// What is measured at a place's first visit, by arm.
const MeasuredGateway* find_gateway(const Visit& visit, std::size_t arm) {
  const auto found = std::ranges::find(visit.gateways, visit.star.name(arm), &MeasuredGateway::arm);
  return found == visit.gateways.end() ? nullptr : &*found;
}

/// A model's parts in its layout.
class PlacedMap {
 public:
  PlacedMap(const RankedMap& ranked, const Trace& trace)
      : ranked_(ranked), trace_(trace), paths_(paths_of_arms(ranked.map)) {}

  std::size_t size() const { return ranked_.map.places.size(); }
  const Pose2& pose(std::size_t place) const { return ranked_.layout.layout_from_place[place]; }
  std::string colour(PlaceArm arm) const { return path_colour(paths_.at(arm)); }
  std::string stripe(PlaceArm arm, double width_px) const {
    return path_stripe(paths_.at(arm), width_px);
  }
  const Star& star(std::size_t place) const { return ranked_.map.places[place].star; }
  const MeasuredGateway* gateway(PlaceArm arm) const {
    const TopologicalMap::Place& place = ranked_.map.places[arm.place.index()];
    return find_gateway(trace_.visits[place.first_visit.index()], arm.arm);
  }
  /// From place to place by way of the gateways.
  std::vector<Point2> way(const TopologicalMap::Segment& segment) const {
    std::vector<Point2> points = outwards(segment.first);
    const std::vector<Point2> back = outwards(segment.second);
    points.insert(points.end(), back.rbegin(), back.rend());
    return points;
  }
  /// In which the arms of a place leave.
  /// @param with_gateways  absent: of all
  std::vector<PlanPicture::Direction> directions(std::size_t place,
                                                 std::optional<bool> with_gateways = {}) const {
    std::vector<PlanPicture::Direction> result;
    for (std::size_t arm = 0; arm < star(place).size(); ++arm) {
      if (with_gateways && star(place).has_gateway(arm) != *with_gateways) continue;
      const PlaceArm own{PlaceId(place), arm};
      double turn_rad = pose(place).heading_rad;
      const MeasuredGateway* found = gateway(own);
      if (!found) {  // an arm without a gateway leads away from its opposite's
        found = gateway({PlaceId(place), star(place).opposite(arm)});
        turn_rad += std::numbers::pi;
      }
      if (found) result.push_back({found->heading_rad + turn_rad, colour(own)});
    }
    return result;
  }

 private:
  std::vector<Point2> outwards(PlaceArm arm) const {
    const Pose2& at = pose(arm.place.index());
    std::vector<Point2> points{at.position()};
    if (const MeasuredGateway* found = gateway(arm))
      points.push_back(at * Point2{found->x_m, found->y_m});
    return points;
  }

  const RankedMap& ranked_;
  const Trace& trace_;
  PathOfArm paths_;
};

/// The gateways of all places, with the names of their arms.
struct NamedGateway {
  PlanPicture::Gateway gateway;
  std::string arm;
};

std::vector<NamedGateway> gateways_of(const PlacedMap& placed, const TopologicalMap& map) {
  std::vector<PlaceArm> travelled;
  for (const auto& [one, other] : map.segments) {
    travelled.push_back(one);
    travelled.push_back(other);
  }
  std::ranges::sort(travelled);
  std::vector<NamedGateway> result;
  for (std::size_t p = 0; p < placed.size(); ++p) {
    for (std::size_t arm = 0; arm < placed.star(p).size(); ++arm) {
      const PlaceArm own{PlaceId(p), arm};
      const MeasuredGateway* found = placed.gateway(own);
      if (!found) continue;
      result.push_back({{.middle = placed.pose(p) * Point2{found->x_m, found->y_m},
                         .outward_rad = found->heading_rad + placed.pose(p).heading_rad,
                         .width_m = found->width_m,
                         .colour = placed.colour(own),
                         .is_open = !std::ranges::binary_search(travelled, own)},
                        found->arm});
    }
  }
  return result;
}

/// The ways driven, straight from gateway to gateway where they are not known.
void add_segments(PlanPicture& picture, const RunReport::Model& model, const PlacedMap& placed) {
  const std::vector<TopologicalMap::Segment>& segments = model.ranked.map.segments;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const PlaceArm arm = segments[i].first;
    const std::vector<Point2> line =
        i < model.ways.size() ? model.ways[i].line : placed.way(segments[i]);
    picture.add_line(line, fmt::format("class=\"segment\" stroke=\"{}\" stroke-width=\"{}\" "
                                       "stroke-opacity=\"0.75\"",
                                       placed.colour(arm), line_width_px));
    if (const std::string stripe = placed.stripe(arm, line_width_px); !stripe.empty())
      picture.add_line(line, stripe);
  }
}

void add_places(PlanPicture& picture, const PlacedMap& placed,
                const std::vector<PoseCovariance>& covariances) {
  for (std::size_t p = 0; p < std::min(placed.size(), covariances.size()); ++p)
    picture.add_ellipse(placed.pose(p), covariances[p]);
  for (std::size_t p = 0; p < placed.size(); ++p) {
    const Point2 at = placed.pose(p).position();
    for (const PlanPicture::Direction& direction : placed.directions(p, false))
      picture.add_dead_end(at, direction);
    picture.add_place(at, p, placed.directions(p));
  }
}

}  // namespace

std::string layout_svg(const RunReport::Model& model, const Trace& trace, PictureSize size,
                       bool has_labels, const std::string& title) {
  const PlacedMap placed(model.ranked, trace);
  const Layout& layout = model.ranked.layout;
  std::vector<Point2> way;
  for (const TimedPose& pose : model.trajectory) way.push_back(pose.layout_from_robot.position());
  PlanBounds shown;
  if (model.global_map) shown.include(*model.global_map);
  for (const Pose2& pose : layout.layout_from_place) shown.include(pose.position(), margin_m);
  for (const Point2 point : way) shown.include(point, margin_m);
  PlanPicture picture(shown, size.max_width_px, size.max_height_px);
  if (model.global_map) picture.add_grid(*model.global_map);
  picture.add_line(way, "stroke=\"#5b6b7f\" stroke-width=\"1\" stroke-opacity=\"0.8\"");
  add_segments(picture, model, placed);
  const std::vector<NamedGateway> gateways = gateways_of(placed, model.ranked.map);
  for (const NamedGateway& each : gateways) picture.add_gateway(each.gateway);
  if (!way.empty()) picture.add_start(way.front());
  add_places(picture, placed, layout.covariances);
  if (!way.empty()) picture.add_robot(model.trajectory.back().layout_from_robot);
  if (has_labels) {
    if (!way.empty()) picture.add_label_at(way.front(), "start");
    for (const NamedGateway& each : gateways) picture.add_label_beside(each.gateway, each.arm);
  }
  picture.add_scale_bar();
  return picture.svg(title);
}

std::string shared_spot_svg(const RunReport& report, const RankedMap& ranked,
                            const SharedSpot& spot, const std::string& title) {
  constexpr double side_px = 220;
  constexpr double round_m = 5;
  PlanBounds shown;
  for (const PlaceId place : {spot.one, spot.other})
    shown.include(ranked.layout.layout_from_place[place.index()].position(), round_m);
  PlanPicture picture(shown, side_px, side_px);
  const auto first_visit = [&](PlaceId place) {
    return ranked.map.places[place.index()].first_visit.index();
  };
  double opacity = 1;
  for (const PlaceId place : {spot.one, spot.other}) {
    const std::size_t visit = first_visit(place);
    if (visit < report.place_maps.size() && report.place_maps[visit])
      picture.add_grid(*report.place_maps[visit], ranked.layout.layout_from_place[place.index()],
                       opacity);
    opacity = 0.5;
  }
  std::string colour = "#d55e00";
  double share = 1;  // of a gateway's width, so that both are seen where they are one
  for (const PlaceId place : {spot.one, spot.other}) {
    const Pose2& pose = ranked.layout.layout_from_place[place.index()];
    for (const MeasuredGateway& gateway : report.trace.visits[first_visit(place)].gateways)
      picture.add_gateway({.middle = pose * gateway.middle(),
                           .outward_rad = gateway.heading_rad + pose.heading_rad,
                           .width_m = share * gateway.width_m,
                           .colour = colour});
    colour = "#0072b2";
    share = 0.5;
  }
  picture.add_scale_bar();
  return picture.svg(title);
}

std::string grid_svg(const Grid& grid, PictureSize size, const std::string& title) {
  PlanBounds shown;
  shown.include(grid);
  if (shown.is_empty()) return {};
  PlanPicture picture(shown, size.max_width_px, size.max_height_px);
  picture.add_grid(grid);
  picture.add_scale_bar();
  return picture.svg(title);
}

PlaceMaps::PlaceMaps(const RunReport& report) : report_(report) {
  constexpr double least_m = 4;
  constexpr double most_m = 9;
  half_side_m_ = least_m;
  for (std::size_t k = 0; k < report.trace.visits.size(); ++k) {
    const Point2 middle = middle_of(k);
    for (const MeasuredGateway& gateway : report.trace.visits[k].gateways) {
      half_side_m_ = std::max(half_side_m_, norm(gateway.middle() - middle) + 2);
    }
  }
  half_side_m_ = std::min(half_side_m_, most_m);
}

/// Of its gateways, in the visit's frame.
Point2 PlaceMaps::middle_of(std::size_t visit) const {
  const std::vector<MeasuredGateway>& gateways = report_.trace.visits[visit].gateways;
  Point2 sum;
  for (const MeasuredGateway& gateway : gateways) sum = sum + gateway.middle();
  return gateways.empty() ? sum : 1 / static_cast<double>(gateways.size()) * sum;
}

Pose2 PlaceMaps::page_from_visit(std::size_t visit) const {
  if (report_.models.empty()) return {};
  const RankedMap& ranked = report_.models.front().ranked;
  if (visit >= ranked.map.visits.size()) return {};
  double turn_rad = ranked.layout.layout_from_place[ranked.map.visits[visit].index()].heading_rad;
  const auto aligned = std::ranges::find(ranked.alignments, VisitId(visit), &Alignment::visit);
  if (aligned != ranked.alignments.end()) turn_rad += aligned->place_from_visit.heading_rad;
  return {0, 0, turn_rad};
}

std::string PlaceMaps::svg(VisitId visit_id) const {
  constexpr double side_px = 170;
  const std::size_t k = visit_id.index();
  const Visit& visit = report_.trace.visits[k];
  const bool has_map = k < report_.place_maps.size() && report_.place_maps[k];
  if (!has_map && visit.gateways.empty()) return {};
  const Pose2 page = page_from_visit(k);
  PlanBounds shown;
  shown.include(page * middle_of(k), half_side_m_);
  PlanPicture picture(shown, side_px, side_px);
  if (has_map) picture.add_grid(*report_.place_maps[k], page);
  const TopologicalMap* map = nullptr;
  PathOfArm paths;
  if (!report_.models.empty() && k < report_.models.front().ranked.map.visits.size()) {
    map = &report_.models.front().ranked.map;
    paths = paths_of_arms(*map);
  }
  for (const MeasuredGateway& gateway : visit.gateways) {
    const std::optional<std::size_t> arm = visit.star.find(gateway.arm);
    std::string colour = no_path_colour;
    if (map && arm) {
      // As many steps clockwise from the arm entered by as in the visit's own star.
      const std::size_t size = visit.star.size();
      const std::size_t shift =
          map->entered[k] && visit.entered_by ? *map->entered[k] + size - *visit.entered_by : 0;
      colour = path_colour(paths.at({map->visits[k], (*arm + shift) % size}));
    }
    std::string label = gateway.arm;
    if (arm && arm == visit.entered_by) label += " in";
    if (arm && arm == visit.left_by) label += " out";
    const PlanPicture::Gateway drawn{.middle = page * gateway.middle(),
                                     .outward_rad = gateway.heading_rad + page.heading_rad,
                                     .width_m = gateway.width_m,
                                     .colour = colour};
    picture.add_gateway(drawn);
    picture.add_label_ahead(drawn, label);
  }
  return picture.svg(fmt::format("place map of visit {}", k));
}

}  // namespace asterism
