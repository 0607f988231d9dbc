#include "perception/detector_laws.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "perception/plugin_error.hpp"

namespace asterism {
namespace {

constexpr double rounding_s = 1e-6;    // programs may print stamps with six decimals
constexpr double rounding_rad = 1e-6;  // gateways in one direction have no order
constexpr double rounding_m = 1e-6;    // nor has one that stands where it is seen from

/// Whether points listed in an order stand clockwise round a centre, once round at most.
bool is_clockwise(const std::vector<Point2>& points, Point2 centre) {
  constexpr double round_rad = 2 * std::numbers::pi;
  std::optional<double> first_rad;
  double reached_rad = 0;
  for (const Point2 point : points) {
    const Point2 ray = point - centre;
    if (norm(ray) < rounding_m) continue;
    if (!first_rad) first_rad = direction(ray);
    double turned_rad = std::fmod(*first_rad - direction(ray) + round_rad, round_rad);
    if (turned_rad > round_rad - rounding_rad && reached_rad < rounding_rad) turned_rad = 0;
    if (turned_rad < rounding_rad && reached_rad > rounding_rad) turned_rad = round_rad;
    if (turned_rad < reached_rad - rounding_rad) return false;
    reached_rad = turned_rad;
  }
  return true;
}

bool is_finite(const MeasuredGateway& gateway) {
  return std::isfinite(gateway.x_m) && std::isfinite(gateway.y_m) &&
         std::isfinite(gateway.heading_rad) && std::isfinite(gateway.width_m);
}

/// Whether the origin of the frame lies within the grid.
bool contains_origin(const Grid& grid) { return grid.contains(grid.cell_at({0, 0})); }

}  // namespace

void DetectorLaws::fed(const Scan& scan) {
  stamps_.push_back({scan.number, scan.stamp_s});
  ++scans_;
}

std::vector<std::string> DetectorLaws::broken_by(const DetectedVisit& next) {
  broken_.clear();
  if (visits_ >= scans_)
    complain("", "more visits than the " + std::to_string(scans_) + " scans", "one a scan at most");
  if (next.visit.star.size() == 0) {
    complain("/star", "no arms", "at least two, the directions of one local-path");
  } else {
    check_arms(next.visit);
    check_gateways(next.visit);
  }
  check_scans(next.visit);
  check_displacement(next.visit);
  check_place_map(next);
  ++visits_;
  return broken_;
}

void DetectorLaws::complain(const std::string& what, const std::string& found,
                            const std::string& expected) {
  broken_.push_back("visit " + std::to_string(visits_) + what + ": found " + found + "; expected " +
                    expected);
}

const DetectorLaws::Stamp* DetectorLaws::find_stamp(long long scan) const {
  const auto stamp = std::ranges::find(stamps_, scan, &Stamp::scan);
  return stamp == stamps_.end() ? nullptr : &*stamp;
}

void DetectorLaws::check_arms(const Visit& visit) {
  const auto check = [&](const char* what, const std::optional<std::size_t>& arm) {
    if (!arm) return;
    if (*arm >= visit.star.size())
      complain(what, "arm " + std::to_string(*arm), "one of " + std::to_string(visit.star.size()));
    else if (!visit.star.has_gateway(*arm))
      complain(what, visit.star.name(*arm) + ", which has no gateway", "an arm with α = 1");
  };
  check("/entered_by", visit.entered_by);
  check("/left_by", visit.left_by);
  if (visits_ > 0 && !visit.entered_by) complain("/entered_by", "nothing", "an arm");
  if (!was_left_) complain("", "a visit after one without left_by", "only the last without it");
  was_left_ = visit.left_by.has_value();
}

void DetectorLaws::check_scans(const Visit& visit) {
  if (!visit.scans) {
    if (visit.stamps_s && !((*visit.stamps_s)[0] <= (*visit.stamps_s)[1]))
      complain("/stamps_s", "out before in", "in before out");
    return;
  }
  const auto [first, last] = *visit.scans;
  if (first > last) {
    complain("/scans", "last " + std::to_string(last) + " before first " + std::to_string(first),
             "first, last");
    return;
  }
  if (last_scan_ && first <= *last_scan_) {
    complain("/scans", "first " + std::to_string(first),
             "a scan after " + std::to_string(*last_scan_) + ", where the visit before ended");
    return;
  }
  const Stamp* in = find_stamp(first);
  const Stamp* out = find_stamp(last);
  if (!in || !out) {
    complain("/scans", "scan " + std::to_string(in ? last : first), "a scan that was given so far");
    return;
  }
  if (visit.stamps_s) {
    const auto [smaller_s, larger_s] = std::minmax({in->stamp_s, out->stamp_s});
    const auto [in_s, out_s] = *visit.stamps_s;
    if (!(std::abs(in_s - smaller_s) <= rounding_s && std::abs(out_s - larger_s) <= rounding_s))
      complain(
          "/stamps_s", std::to_string(in_s) + ", " + std::to_string(out_s),
          std::to_string(smaller_s) + ", " + std::to_string(larger_s) + ", those of its scans");
  }
  last_scan_ = last;
  while (!stamps_.empty() && &stamps_.front() != out) stamps_.pop_front();
}

void DetectorLaws::check_gateways(const Visit& visit) {
  std::vector<std::optional<Point2>> at(visit.star.size());
  for (const MeasuredGateway& gateway : visit.gateways) {
    const std::string name = '"' + one_line(gateway.arm, 40) + '"';
    const auto arm = visit.star.find(gateway.arm);
    if (!arm || !visit.star.has_gateway(*arm)) {
      complain("/gateways", name, "an arm of the star with α = 1");
      continue;
    }
    if (at[*arm]) complain("/gateways", name + " again", "each arm once");
    if (!is_finite(gateway) || gateway.width_m <= 0)
      complain("/gateways", name + " without finite pose and positive width", "both");
    at[*arm] = gateway.middle();
  }
  std::vector<Point2> clockwise;
  for (const auto& point : at)
    if (point) clockwise.push_back(*point);
  if (clockwise.size() < 3) return;  // any order of two is a clockwise one
  // Either centre will do: neither has a clear view of every place.
  if (!is_clockwise(clockwise, mean(clockwise)) && !is_clockwise(clockwise, {}))
    complain("/gateways", "gateways in another order", "the star's, clockwise");
}

void DetectorLaws::check_displacement(const Visit& visit) {
  if (const auto& moved = visit.displacement) {
    if (!std::isfinite(moved->x_m) || !std::isfinite(moved->y_m) ||
        !std::isfinite(moved->heading_rad))
      complain("/displacement", "a number that is not finite", "a pose");
    if (!is_covariance(moved->covariance))
      complain("/displacement/covariance", "an asymmetric or indefinite matrix",
               "a symmetric, positive semi-definite matrix, row by row");
  }
  if (visits_ == 0) return;  // nothing was left yet
  const bool has_displacement = visit.displacement.has_value();
  if (has_displacements_.value_or(has_displacement) != has_displacement)
    complain("/displacement", has_displacement ? "one" : "nothing",
             has_displacement ? "none, as before" : "one, as before");
  has_displacements_ = has_displacement;
}

void DetectorLaws::check_place_map(const DetectedVisit& detected) {
  if (!detected.place_map) return;
  const Grid& map = *detected.place_map;
  if (detected.visit.lpm) complain("/lpm", "a file beside the place map", "one of the two");
  if (map.width <= 0 || map.height <= 0 || !(map.resolution_m > 0) ||
      map.log_odds.size() !=
          static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height)) {
    complain("/place_map", std::to_string(map.log_odds.size()) + " cells",
             std::to_string(map.width) + " x " + std::to_string(map.height) + " of positive size");
    return;
  }
  if (std::ranges::any_of(map.log_odds, [](float odds) { return std::isnan(odds); }))
    complain("/place_map", "log-odds that are no number", "numbers");
  if (!contains_origin(map))
    complain("/place_map", "a map without the origin of the visit's frame", "the origin inside");
}

}  // namespace asterism
