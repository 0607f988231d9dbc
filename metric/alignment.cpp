#include "metric/alignment.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "metric/chi_squared.hpp"
#include "metric/exponential.hpp"

namespace asterism {
namespace {

constexpr std::array kReaches_m{1.0, 0.5, 0.3};  // how far a wall may be from its other, by turns
constexpr int kStepsAReach = 8;
constexpr double kSameWall = 0.8;  // cosine of the angle between the two
constexpr double kMatched_m = 0.2;
constexpr double kDone = 1e-5;
constexpr std::size_t kFewestWalls = 30;
// Without a gateway in common a visit was somewhere at the place, facing anywhere.
constexpr double kSomewhere_m = 2;
constexpr double kAnywhere_rad = 1;

using Matrix3 = Eigen::Matrix3d;
using Vector3 = Eigen::Vector3d;

// Gauss-Newton's equations of small motions in the visit's frame.
struct Equations {
  Matrix3 curvature = Matrix3::Zero();
  Vector3 slope = Vector3::Zero();

  void add(const Vector3& jacobian, double residual, double information) {
    curvature += information * jacobian * jacobian.transpose();
    slope -= information * residual * jacobian;
  }
};

// Moving the visit by a small motion in its frame moves a point of it along `direction` so much.
Vector3 along(const Pose2& place_from_visit, Point2 in_visit, Point2 direction) {
  const Point2 in_visit_frame = Pose2{0, 0, -place_from_visit.heading_rad} * direction;
  return {in_visit_frame.x_m, in_visit_frame.y_m, cross(in_visit, in_visit_frame)};
}

struct GatewayError {
  double aside_m;
  double ahead_m;
  double turned_rad;
};

GatewayError error(const Pose2& place_from_visit, const MeasuredGateway& first,
                   const MeasuredGateway& second) {
  const Point2 off =
      place_from_visit * Point2{second.x_m, second.y_m} - Point2{first.x_m, first.y_m};
  const Point2 out = unit_vector(first.heading_rad);
  return {cross(out, off), dot(out, off),
          wrapped(place_from_visit.heading_rad + second.heading_rad - first.heading_rad)};
}

PoseCovariance numbers(const Matrix3& matrix) {
  PoseCovariance result;
  for (std::size_t i = 0; i < 9; ++i)
    result[i] = matrix(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3));
  return result;
}

double square(double x) { return x * x; }

// Share of the walls of one map, where the other knows its way about, that the other has too.
struct Share {
  std::size_t matched = 0;
  std::size_t known = 0;
};

Share matched(const PlaceWalls& of, const PlaceWalls& by, const Pose2& by_from_of) {
  Share share;
  for (const WallPiece& piece : of.pieces()) {
    const Point2 point = by_from_of * piece.point;
    if (!by.is_known(point)) continue;
    ++share.known;
    const WallPiece* near = by.nearest(point);
    if (near != nullptr && norm(near->point - point) <= kMatched_m) ++share.matched;
  }
  return share;
}

}  // namespace

PlaceAlignments::PlaceAlignments(const Trace& trace, std::vector<std::optional<Grid>> place_maps,
                                 const AlignmentOptions& options)
    : trace_(trace),
      place_maps_(std::move(place_maps)),
      options_(options),
      walls_(trace.visits.size()) {
  place_maps_.resize(trace.visits.size());
}

const Alignment& PlaceAlignments::operator()(VisitId first, VisitId visit, std::size_t entered) {
  const auto [entry, fresh] = known_.try_emplace({first.index(), visit.index(), entered},
                                                 Alignment{visit, PlaceId(first.index())});
  if (fresh) entry->second = align(pairs(first, visit, entered), first, visit);
  return entry->second;
}

const PlaceWalls* PlaceAlignments::walls(VisitId visit) {
  std::optional<PlaceWalls>& walls = walls_[visit.index()];
  const std::optional<Grid>& map = place_maps_[visit.index()];
  if (!walls && map) walls.emplace(*map, options_.radius_m);
  return walls ? &*walls : nullptr;
}

std::vector<PlaceAlignments::GatewayPair> PlaceAlignments::pairs(VisitId first, VisitId visit,
                                                                 std::size_t entered) const {
  const Visit& one = trace_.visits[first.index()];
  const Visit& other = trace_.visits[visit.index()];
  const std::size_t arms = one.star.size();
  const std::size_t turned = entered + arms - other.entered_by.value_or(0);
  std::vector<GatewayPair> result;
  for (const MeasuredGateway& gateway : other.gateways) {
    for (std::size_t arm = 0; arm < arms; ++arm) {
      if (other.star.name(arm) != gateway.arm) continue;
      const std::string name = one.star.name((arm + turned) % arms);
      const auto same = std::ranges::find(one.gateways, name, &MeasuredGateway::arm);
      if (same != one.gateways.end()) result.push_back({*same, gateway});
    }
  }
  return result;
}

Alignment PlaceAlignments::align(const std::vector<GatewayPair>& pairs, VisitId first,
                                 VisitId visit) {
  Alignment result{visit, PlaceId(first.index())};
  if (pairs.empty()) {
    const double somewhere = square(kSomewhere_m);
    result.covariance = {somewhere, 0, 0, 0, somewhere, 0, 0, 0, square(kAnywhere_rad)};
    return result;
  }
  // To begin with: turned as the gateways are on average, and moved.
  Point2 turned = {};
  for (const auto& [one, other] : pairs)
    turned = turned + unit_vector(one.heading_rad - other.heading_rad);
  Pose2 pose{0, 0, direction(turned)};
  Point2 moved = {};
  for (const auto& [one, other] : pairs)
    moved = moved + Point2{one.x_m, one.y_m} - pose * Point2{other.x_m, other.y_m};
  moved = (1.0 / static_cast<double>(pairs.size())) * moved;
  pose = {moved.x_m, moved.y_m, pose.heading_rad};

  const PlaceWalls* const of_first = walls(first);
  const PlaceWalls* const of_visit = walls(visit);
  const bool has_walls = of_first != nullptr && of_visit != nullptr &&
                         of_first->pieces().size() >= kFewestWalls &&
                         of_visit->pieces().size() >= kFewestWalls;
  Matrix3 curvature;
  const auto step = [&](double reach_m) {
    Equations equations;
    for (const auto& [one, other] : pairs) {
      const Point2 at{other.x_m, other.y_m};
      const Point2 out = unit_vector(one.heading_rad);
      const GatewayError off = error(pose, one, other);
      equations.add(along(pose, at, {-out.y_m, out.x_m}), off.aside_m,
                    1 / square(options_.aside_m));
      equations.add(along(pose, at, out), off.ahead_m, 1 / square(options_.ahead_m));
      equations.add({0, 0, 1}, off.turned_rad, 1 / square(options_.heading_rad));
    }
    if (has_walls) {
      for (const WallPiece& piece : of_visit->pieces()) {
        const Point2 point = pose * piece.point;
        const WallPiece* near = of_first->nearest(point);
        if (near == nullptr || norm(near->point - point) > reach_m) continue;
        const Point2 normal = Pose2{0, 0, pose.heading_rad} * piece.normal;
        if (std::abs(dot(normal, near->normal)) < kSameWall) continue;
        const double off_m = dot(near->normal, point - near->point);
        // Half as far as the reach, a bit of wall counts half.
        const double weight = 1 / (1 + square(2 * off_m / reach_m));
        equations.add(along(pose, piece.point, near->normal), off_m,
                      weight / square(options_.wall_m));
      }
    }
    curvature = equations.curvature;
    const Vector3 motion = curvature.ldlt().solve(equations.slope);
    pose = pose * exponential({motion[0], motion[1], motion[2]});
    return motion.norm();
  };
  for (const double reach_m : kReaches_m) {
    for (int i = 0; i < kStepsAReach && step(reach_m) > kDone; ++i) {
    }
  }

  result.place_from_visit = pose;
  Matrix3 covariance = curvature.inverse();
  if (has_walls) {
    const Vector3 shared{square(options_.shared_m), square(options_.shared_m),
                         square(options_.shared_rad)};
    covariance.diagonal() += shared;
    const Share ours = matched(*of_visit, *of_first, pose);
    const Share theirs = matched(*of_first, *of_visit, inverse(pose));
    result.matched_walls = static_cast<double>(ours.matched + theirs.matched) /
                           static_cast<double>(std::max<std::size_t>(1, ours.known + theirs.known));
  }
  result.covariance = numbers(covariance);
  Misfit& misfit = result.misfit;
  for (const auto& [one, other] : pairs) {
    const GatewayError off = error(pose, one, other);
    misfit.chi_squared += square(off.aside_m / options_.aside_m) +
                          square(off.ahead_m / options_.ahead_m) +
                          square(off.turned_rad / options_.heading_rad);
  }
  misfit.degrees_of_freedom = 3 * pairs.size() - (has_walls ? 0 : 3);
  misfit.tail_probability = chi_squared_tail(misfit.chi_squared, misfit.degrees_of_freedom);
  return result;
}

}  // namespace asterism
