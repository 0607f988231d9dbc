#include "perception/scan_detector.hpp"

#include <algorithm>
#include <cmath>

namespace asterism {
namespace {

constexpr double kStep_m = 0.05;  // the way keeps no points closer than this
constexpr std::size_t kLongestWay = 8000;
constexpr double kAside_m = 1.0;          // how far beside a gateway's ends one is still beyond it
constexpr double kSameHeading_rad = 0.6;  // how far gateways seen twice may differ
constexpr double kSameSpot_m = 2.0;
constexpr double kLost_m = 10;        // farther from where a place was seen, one is not in it
constexpr double kLongestScan_s = 1;  // a gap in the log counts as no more time than this

// How far a point lies beyond a gateway, and beside its axis.
struct Beyond {
  double along_m = 0;
  double aside_m = 0;
};

Beyond beyond(const Gateway& gateway, Point2 point) {
  const Point2 out = unit_vector(gateway.outward_rad);
  const Point2 away = point - gateway.middle;
  return {dot(away, out), std::abs(cross(out, away))};
}

const std::vector<Gateway>& gateways_of(const LocalTopology& topology) {
  return topology.neighbourhood->gateways;
}

// Whether two looks saw the same star at the same spot, arm by arm in the same directions.
bool same_star(const LocalTopology& a, const LocalTopology& b) {
  const std::size_t gateways = gateways_of(a).size();
  if (gateways != gateways_of(b).size() || a.star->star.size() != b.star->star.size()) return false;
  for (std::size_t i = 0; i < gateways; ++i) {
    std::size_t match = 0;
    const auto off = [&](std::size_t j) {
      return std::abs(wrapped(gateways_of(a)[i].outward_rad - gateways_of(b)[j].outward_rad));
    };
    for (std::size_t j = 1; j < gateways; ++j) {
      if (off(j) < off(match)) match = j;
    }
    if (off(match) > kSameHeading_rad ||
        norm(gateways_of(a)[i].middle - gateways_of(b)[match].middle) > kSameSpot_m ||
        a.star->star.view(a.star->arm_of_gateway[i]) !=
            b.star->star.view(b.star->arm_of_gateway[match])) {
      return false;
    }
  }
  return true;
}

}  // namespace

ScanDetector::ScanDetector(const ScanDetectorOptions& options)
    : options_(options),
      map_(options.lpm),
      localiser_(options.localiser, {0, 0, options.start_heading_rad}) {}

std::optional<DetectedVisit> ScanDetector::observe(const Scan& scan) {
  follow(scan);
  const double passed_s =
      last_stamp_s_ ? std::clamp(scan.stamp_s - *last_stamp_s_, 0.0, kLongestScan_s) : 0;
  last_stamp_s_ = scan.stamp_s;
  look(passed_s);

  const Sight* const place = best_sight();
  if (!place) return std::nullopt;
  const std::optional<std::size_t> out = outside(*place, robot_.position(), options_.leave_m);
  if (out) return leave(*place, *out);
  if (norm(robot_.position() - place->from) > kLost_m) {
    forget();
  }
  return std::nullopt;
}

void ScanDetector::forget() {
  sights_.clear();
  stayed_in_place_s_ = 0;
  fixed_ = false;
}

// Localises, scrolls and draws.
void ScanDetector::follow(const Scan& scan) {
  const Localiser::Estimate estimate = localiser_.observe(scan, map_.grid());
  robot_ = estimate.map_from_robot;
  const double edge_m = 0.3 * options_.lpm.cells * options_.lpm.resolution_m;
  const Grid& grid = map_.grid();
  const Point2 centre = grid.centre({grid.width / 2, grid.height / 2});
  if (!fixed_ || norm(robot_.position() - centre) > edge_m) map_.scroll_to(robot_.position());

  const Step here{scan.number, scan.stamp_s, robot_};
  const auto moved = [&](const Pose2& from, double by_m, double by_rad) {
    const Pose2 since = inverse(from) * robot_;
    return norm(since.position()) > by_m || std::abs(since.heading_rad) > by_rad;
  };
  const bool sharp = std::abs(estimate.turned_rad) < options_.blurred_rad || estimate.match > 0.7;
  if (sharp && (!drawn_ || moved(drawn_->map_from_robot, options_.redraw_m, options_.redraw_rad))) {
    map_.update(scan, robot_);
    drawn_ = here;
  }
  if (way_.empty() || norm(way_.back().map_from_robot.position() - robot_.position()) > kStep_m) {
    way_.push_back(here);
    if (way_.size() > kLongestWay) way_.pop_front();
  }
}

// Looks at the surroundings, and counts how long which star was seen.
void ScanDetector::look(double passed_s) {
  if (norm(robot_.position() - anchor_) > options_.stay_m) {
    anchor_ = robot_.position();
    stayed_s_ = 0;
  }
  stayed_s_ += passed_s;
  std::vector<Point2> driven;
  for (auto step = way_.rbegin();
       step != way_.rend() &&
       map_.grid().contains(map_.grid().cell_at(step->map_from_robot.position()));
       ++step) {
    driven.push_back(step->map_from_robot.position());
  }
  surroundings_ = local_topology(map_.grid(), robot_.position(), options_.topology, driven);
  const bool possible_place = surroundings_.star && !is_on_path(*surroundings_.star);
  fixed_ = possible_place || stayed_in_place_s_ >= options_.hold_s;
  if (!possible_place || surroundings_.neighbourhood->unknown_border > options_.explored) return;
  // What is seen from beyond a gateway of the place where the robot stayed belongs to another.
  const Sight* const place = best_sight();
  if (place && stayed_in_place_s_ >= options_.hold_s && place->seen_s >= options_.hold_s &&
      outside(*place, robot_.position(), 0)) {
    return;
  }
  for (Sight& sight : sights_) sight.seen_s *= std::exp(-passed_s / options_.memory_s);
  Sight& sight = sight_of(surroundings_);
  sight.seen_s += passed_s * (surroundings_.neighbourhood->ends_known ? 1 : options_.half_seen);
  sight.topology = surroundings_;
  sight.from = robot_.position();
  if (stayed_s_ >= options_.stay_s) stayed_in_place_s_ += passed_s;
}

ScanDetector::Sight& ScanDetector::sight_of(const LocalTopology& seen) {
  for (Sight& sight : sights_) {
    if (same_star(sight.topology, seen)) return sight;
  }
  return sights_.emplace_back();
}

const ScanDetector::Sight* ScanDetector::best_sight() const {
  const Sight* best = nullptr;
  for (const Sight& sight : sights_) {
    if (!best || sight.seen_s > best->seen_s) {
      best = &sight;
    }
  }
  return best;
}

// The gateway that a point lies beyond by this much, nearest its axis.
std::optional<std::size_t> ScanDetector::outside(const Sight& place, Point2 point,
                                                 double by_m) const {
  std::optional<std::size_t> found;
  double least_m = 0;
  const auto& gateways = gateways_of(place.topology);
  for (std::size_t i = 0; i < gateways.size(); ++i) {
    const auto [along_m, aside_m] = beyond(gateways[i], point);
    if (along_m < by_m || aside_m > gateways[i].width_m / 2 + kAside_m) continue;
    if (!found || aside_m < least_m) {
      found = i;
      least_m = aside_m;
    }
  }
  return found;
}

// The last time before step `before` that the robot came in: through which gateway, and when.
std::optional<ScanDetector::Crossing> ScanDetector::entered(const Sight& place,
                                                            std::size_t before) const {
  for (std::size_t i = before; i-- > 0;) {
    const auto gateway = outside(place, way_[i].map_from_robot.position(), options_.leave_m);
    if (!gateway) continue;
    std::size_t inside = i;
    while (inside < before &&
           beyond(gateways_of(place.topology)[*gateway], way_[inside].map_from_robot.position())
                   .along_m > 0) {
      ++inside;
    }
    return Crossing{*gateway, inside};
  }
  return std::nullopt;
}

std::optional<DetectedVisit> ScanDetector::leave(const Sight& place, std::size_t gateway) {
  const auto& gateways = gateways_of(place.topology);
  std::size_t inside = way_.size() - 1;
  while (inside > 0 &&
         beyond(gateways[gateway], way_[inside].map_from_robot.position()).along_m > 0) {
    --inside;
  }
  const std::optional<Crossing> in = entered(place, inside);
  const bool stayed = stayed_in_place_s_ >= options_.hold_s;
  // Of a place driven through, both the gateways and the robot's heading tell of a turn.
  const auto turned = [&](double from_rad, double to_rad) {
    return std::abs(wrapped(to_rad - from_rad)) > options_.turn_off_rad;
  };
  const bool turned_off =
      in && place.seen_s >= options_.hold_s && in->gateway != gateway &&
      turned(gateways[in->gateway].outward_rad + std::numbers::pi, gateways[gateway].outward_rad) &&
      turned(way_[in->inside].map_from_robot.heading_rad, robot_.heading_rad);
  std::optional<DetectedVisit> result;
  if ((stayed || turned_off) && (in || !last_visit_)) {
    result = visit(place, in, Crossing{gateway, inside});
    way_.erase(way_.begin(), way_.begin() + static_cast<std::ptrdiff_t>(inside));
  }
  forget();
  return result;
}

DetectedVisit ScanDetector::visit(const Sight& place, std::optional<Crossing> in,
                                  std::optional<Crossing> out) {
  const LocalStar& local = *place.topology.star;
  const auto& gateways = gateways_of(place.topology);
  const Step& first = in ? way_[in->inside] : way_.front();
  const Step& last = out ? way_[out->inside] : way_.back();
  const Pose2 visit_from_map = inverse(first.map_from_robot);

  DetectedVisit result{.visit = {.star = local.star}};
  Visit& visit = result.visit;
  if (in) visit.entered_by = local.arm_of_gateway[in->gateway];
  if (out) visit.left_by = local.arm_of_gateway[out->gateway];
  visit.scans = {first.scan, last.scan};
  visit.stamps_s = {first.stamp_s, last.stamp_s};
  for (std::size_t i = 0; i < gateways.size(); ++i) {
    const Pose2 placed = visit_from_map * Pose2{gateways[i].middle.x_m, gateways[i].middle.y_m,
                                                gateways[i].outward_rad};
    visit.gateways.push_back({local.star.name(local.arm_of_gateway[i]), placed.x_m, placed.y_m,
                              placed.heading_rad, gateways[i].width_m});
  }
  if (last_visit_) {
    const Pose2 moved = inverse(*last_visit_) * first.map_from_robot;
    visit.displacement = Displacement{moved.x_m, moved.y_m, moved.heading_rad, {}};
  }
  last_visit_ = first.map_from_robot;
  last_place_ = {place.topology, first.map_from_robot, {}};
  for (std::size_t i = in ? in->inside : 0; i <= (out ? out->inside : way_.size() - 1); ++i) {
    last_place_->way.push_back(way_[i].map_from_robot.position());
  }
  result.place_map = map_.grid();
  result.place_map->frame_from_grid = visit_from_map * map_.grid().frame_from_grid;
  return result;
}

std::optional<DetectedVisit> ScanDetector::finish() {
  const Sight* const place = best_sight();
  if (!place || stayed_in_place_s_ < options_.hold_s) return std::nullopt;
  const std::optional<Crossing> in = entered(*place, way_.size());
  if (!in && last_visit_) return std::nullopt;
  DetectedVisit last = visit(*place, in, std::nullopt);
  forget();
  return last;
}

}  // namespace asterism
