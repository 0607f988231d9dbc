#include "perception/scan_detector.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asterism {
namespace {

constexpr double way_step_m = 0.05;  // the way keeps no points closer than this
constexpr std::size_t longest_way = 8000;
constexpr double beside_m = 1.0;          // how far beside a gateway's ends one is still beyond it
constexpr double same_heading_rad = 0.6;  // how far gateways seen twice may differ
constexpr double same_spot_m = 2.0;
constexpr double lost_m = 10;  // farther from a spot, one has left its place
constexpr double just_outside_m = 1.0;
constexpr double look_back_m = 0.3;   // how far the robot drives between two looks back
constexpr double longest_scan_s = 1;  // a gap in the log counts as no more time than this

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
    if (off(match) > same_heading_rad ||
        norm(gateways_of(a)[i].middle - gateways_of(b)[match].middle) > same_spot_m ||
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
  const double passed_s = passed_since_last(scan.stamp_s);
  if (!way_.empty()) way_.back().passed_s += passed_s;
  follow(scan);
  find_stop(passed_s);
  find_corner();
  look();

  if (spots_.empty()) return std::nullopt;
  if (judged_from_ && norm(robot_.position() - *judged_from_) < look_back_m) return std::nullopt;
  judged_from_ = robot_.position();
  Looks looks;
  for (std::size_t i = 0; i < spots_.size(); ++i) {
    const double away_m = norm(robot_.position() - spots_[i]);
    if (away_m < options_.leave_m) continue;
    const std::optional<Place> place = place_at(spots_[i], looks);
    if (place) {
      const std::optional<std::size_t> out = outside(*place, robot_.position(), options_.leave_m);
      if (out) return leave(*place, *out);
    }
    if (away_m > lost_m) spots_.erase(spots_.begin() + static_cast<std::ptrdiff_t>(i--));
  }
  return std::nullopt;
}

// The order of the log rules: where its stamps run backwards on the whole, so does its clock.
// Single ones that do are no time.
double ScanDetector::passed_since_last(double stamp_s) {
  const double later_s = last_stamp_s_ ? stamp_s - *last_stamp_s_ : 0;
  last_stamp_s_ = stamp_s;
  clock_s_ += std::clamp(later_s, -longest_scan_s, longest_scan_s);
  return std::clamp(clock_s_ < 0 ? -later_s : later_s, 0.0, longest_scan_s);
}

// Localises, scrolls and draws.
void ScanDetector::follow(const Scan& scan) {
  const Localiser::Estimate estimate = localiser_.observe(scan, map_);
  robot_ = estimate.map_from_robot;
  if (estimate.jump) jumps_.push_back({scan.number, *estimate.jump});
  const double edge_m = 0.3 * options_.lpm.cells * options_.lpm.resolution_m;
  const Grid& grid = map_.grid();
  const Point2 centre = grid.centre({grid.width / 2, grid.height / 2});
  if (!fixed_ || norm(robot_.position() - centre) > edge_m) map_.scroll_to(robot_.position());

  const Step here{scan.number, scan.stamp_s, robot_, estimate.drift};
  const auto moved = [&](const Pose2& from, double by_m, double by_rad) {
    const Pose2 since = inverse(from) * robot_;
    return norm(since.position()) > by_m || std::abs(since.heading_rad) > by_rad;
  };
  const bool sharp = std::abs(estimate.turned_rad) < options_.blurred_rad || estimate.match > 0.7;
  if (sharp && (!drawn_ || moved(drawn_->map_from_robot, options_.redraw_m, options_.redraw_rad))) {
    map_.update(scan, robot_);
    drawn_ = here;
  }
  if (way_.empty() ||
      norm(way_.back().map_from_robot.position() - robot_.position()) > way_step_m) {
    way_.push_back(here);
    if (way_.size() > longest_way) way_.pop_front();
  }
}

// Looks at the surroundings. The map does not scroll at a possible place.
void ScanDetector::look() {
  surroundings_ = local_topology(map_.grid(), robot_.position(), options_.topology, driven());
  fixed_ = !spots_.empty() || (surroundings_.star && !is_on_path(*surroundings_.star));
}

std::vector<Point2> ScanDetector::driven() const {
  std::vector<Point2> result;
  for (auto step = way_.rbegin();
       step != way_.rend() &&
       map_.grid().contains(map_.grid().cell_at(step->map_from_robot.position()));
       ++step) {
    result.push_back(step->map_from_robot.position());
  }
  return result;
}

void ScanDetector::find_stop(double passed_s) {
  if (norm(robot_.position() - anchor_) > options_.stay_m) {
    anchor_ = robot_.position();
    stayed_s_ = 0;
  }
  stayed_s_ += passed_s;
  if (stayed_s_ < options_.stay_s) return;
  for (auto step = way_.rbegin();
       step != way_.rend() && norm(step->map_from_robot.position() - anchor_) <= options_.stay_m &&
       !step->stopped;
       ++step) {
    step->stopped = true;
  }
  mark(anchor_);
}

// Where the way before a step and the way behind it lie in different directions.
void ScanDetector::find_corner() {
  const auto at = [&](std::size_t step) { return way_[step].map_from_robot.position(); };
  const auto back = [&](std::size_t from) {
    double length_m = 0;
    std::size_t step = from;
    for (; step > 0 && length_m < options_.corner_m; --step) {
      length_m += norm(at(step) - at(step - 1));
    }
    return step;
  };
  const std::size_t last = way_.size() - 1;
  const std::size_t middle = back(last);
  const std::size_t first = back(middle);
  const double shortest_m = 0.5 * options_.corner_m;
  if (norm(at(last) - at(middle)) < shortest_m || norm(at(middle) - at(first)) < shortest_m) return;
  if (std::abs(wrapped(direction(at(last) - at(middle)) - direction(at(middle) - at(first)))) <
      options_.corner_rad) {
    return;
  }
  mark(at(middle));
}

void ScanDetector::mark(Point2 spot) {
  const bool marked = std::any_of(spots_.begin(), spots_.end(), [&](Point2 other) {
    return norm(other - spot) < options_.stay_m;
  });
  if (!marked) spots_.push_back(spot);
}

// The star that holds longest along the way near a spot.
std::optional<ScanDetector::Place> ScanDetector::place_at(Point2 spot, Looks& looks) const {
  std::vector<Place> places;
  const auto look_from = [&](Point2 from, double held_s, bool stopped) {
    const std::optional<std::size_t> star = star_seen_from(from, looks);
    if (!star) return;
    if (places.size() <= *star) places.resize(*star + 1);
    places[*star].held_s += held_s;
    if (stopped) places[*star].stopped_s += held_s;
  };
  for (std::size_t i = 0; i < way_.size();) {
    const Point2 from = way_[i].map_from_robot.position();
    double stopped_s = 0;
    double driven_m = 0;
    Point2 to = from;
    for (; i < way_.size() && driven_m < options_.spot_m; ++i) {
      if (way_[i].stopped) stopped_s += way_[i].passed_s;
      if (i + 1 == way_.size()) continue;
      to = way_[i + 1].map_from_robot.position();
      driven_m += norm(to - way_[i].map_from_robot.position());
    }
    if (norm(from - spot) > options_.near_m) continue;
    if (stopped_s > 0) look_from(from, stopped_s, true);
    const int times = std::max(1, static_cast<int>(driven_m / options_.spot_m));
    for (int time = 0; time < times; ++time) {
      look_from(from + (1.0 * time / times) * (to - from),
                options_.drive_s_per_m * driven_m / times, false);
    }
  }
  const auto longest =
      std::max_element(places.begin(), places.end(),
                       [](const Place& a, const Place& b) { return a.held_s < b.held_s; });
  if (longest == places.end() || longest->held_s == 0) return std::nullopt;
  longest->topology = looks.stars[static_cast<std::size_t>(longest - places.begin())];
  longest->topology.space = surroundings_.space;
  longest->topology.skeleton = surroundings_.skeleton;
  return *longest;
}

// The number of the star seen from a point; nothing on a path, and where too little is known.
std::optional<std::size_t> ScanDetector::star_seen_from(Point2 from, Looks& looks) const {
  const FreeSpace& space = surroundings_.space;
  const Skeleton& lines = surroundings_.skeleton;
  const auto [look, fresh] = looks.star_of_core.try_emplace(core(space, lines, from));
  if (!fresh) return look->second;
  std::optional<Neighbourhood> seen = neighbourhood(space, lines, from);
  if (!seen || seen->gateways.empty() || seen->unknown_border > options_.explored) return {};
  LocalStar star = local_star(seen->gateways, options_.topology.star);
  if (is_on_path(star)) return {};
  LocalTopology topology{{}, {}, std::move(seen), std::move(star)};
  const auto known =
      std::find_if(looks.stars.begin(), looks.stars.end(),
                   [&](const LocalTopology& other) { return same_star(other, topology); });
  look->second = static_cast<std::size_t>(known - looks.stars.begin());
  if (known == looks.stars.end()) looks.stars.push_back(std::move(topology));
  return look->second;
}

// The gateway that a point lies beyond by this much, nearest its axis.
std::optional<std::size_t> ScanDetector::outside(const Place& place, Point2 point,
                                                 double by_m) const {
  std::optional<std::size_t> found;
  double least_m = 0;
  const auto& gateways = gateways_of(place.topology);
  for (std::size_t i = 0; i < gateways.size(); ++i) {
    const auto [along_m, aside_m] = beyond(gateways[i], point);
    if (along_m < by_m || aside_m > gateways[i].width_m / 2 + beside_m) continue;
    if (!found || aside_m < least_m) {
      found = i;
      least_m = aside_m;
    }
  }
  return found;
}

// Where the robot stops just outside, it is at the place still.
bool ScanDetector::is_inside(const Gateway& gateway, const Step& step) {
  const double along_m = beyond(gateway, step.map_from_robot.position()).along_m;
  return along_m <= (step.stopped ? just_outside_m : 0);
}

// The last time before step `before` that the robot came in: through which gateway, and when.
std::optional<ScanDetector::Crossing> ScanDetector::entered(const Place& place,
                                                            std::size_t before) const {
  for (std::size_t i = before; i-- > 0;) {
    const auto gateway = outside(place, way_[i].map_from_robot.position(), options_.leave_m);
    if (!gateway) continue;
    std::size_t inside = i;
    while (inside < before && !is_inside(gateways_of(place.topology)[*gateway], way_[inside])) {
      ++inside;
    }
    return Crossing{*gateway, inside};
  }
  return std::nullopt;
}

std::optional<DetectedVisit> ScanDetector::leave(const Place& place, std::size_t gateway) {
  const auto& gateways = gateways_of(place.topology);
  std::size_t inside = way_.size() - 1;
  while (inside > 0 && !is_inside(gateways[gateway], way_[inside])) --inside;
  const std::optional<Crossing> in = entered(place, inside);
  // Driven through, a place counts if the robot turned there into another path.
  const LocalStar& local = *place.topology.star;
  const auto path = [&](std::size_t of) { return local.star.arm(local.arm_of_gateway[of]).label; };
  const bool stopped = place.stopped_s >= options_.hold_s;
  const bool changed_paths = in && place.held_s >= options_.hold_s &&
                             path(in->gateway) != path(gateway) &&
                             std::abs(wrapped(gateways[in->gateway].outward_rad + std::numbers::pi -
                                              gateways[gateway].outward_rad)) > options_.corner_rad;
  spots_.clear();
  if ((!stopped && !changed_paths) || (!in && last_visit_)) return std::nullopt;
  DetectedVisit result = visit(place, in, Crossing{gateway, inside});
  way_.erase(way_.begin(), way_.begin() + static_cast<std::ptrdiff_t>(inside));
  return result;
}

DetectedVisit ScanDetector::visit(const Place& place, std::optional<Crossing> in,
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
  const auto [smaller_s, larger_s] = std::minmax({first.stamp_s, last.stamp_s});
  visit.stamps_s = {smaller_s, larger_s};
  for (std::size_t i = 0; i < gateways.size(); ++i) {
    const Pose2 placed = visit_from_map * Pose2{gateways[i].middle.x_m, gateways[i].middle.y_m,
                                                gateways[i].outward_rad};
    visit.gateways.push_back({local.star.name(local.arm_of_gateway[i]), placed.x_m, placed.y_m,
                              placed.heading_rad, gateways[i].width_m});
  }
  const DriftingPose here{first.map_from_robot, first.drift};
  if (last_visit_) {
    const Pose2 moved = inverse(last_visit_->map_from_robot) * here.map_from_robot;
    visit.displacement = make_displacement(moved, covariance_between(*last_visit_, here));
  }
  last_visit_ = here;
  last_place_ = {place.topology, first.map_from_robot, {}};
  for (std::size_t i = in ? in->inside : 0; i <= (out ? out->inside : way_.size() - 1); ++i) {
    last_place_->way.push_back(way_[i].map_from_robot.position());
  }
  result.place_map = map_.grid();
  result.place_map->frame_from_grid = visit_from_map * map_.grid().frame_from_grid;
  return result;
}

std::optional<DetectedVisit> ScanDetector::finish() {
  Looks looks;
  while (!spots_.empty()) {
    const std::optional<Place> place = place_at(spots_.front(), looks);
    spots_.erase(spots_.begin());
    if (!place || place->stopped_s < options_.hold_s) continue;
    const std::optional<Crossing> in = entered(*place, way_.size());
    if (!in && last_visit_) continue;
    spots_.clear();
    return visit(*place, in, std::nullopt);
  }
  return std::nullopt;
}

}  // namespace asterism
