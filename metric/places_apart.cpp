#include "metric/places_apart.hpp"

#include <algorithm>
#include <cmath>

#include "core/squared.hpp"
#include "metric/chi_squared.hpp"
#include "metric/layout_covariance.hpp"

namespace asterism {
namespace {

// Below this, m², a spread is rounding.
constexpr double least_variance_m2 = 1e-12;

}  // namespace

std::optional<PlaceDisc> disc_of(const Visit& visit) {
  if (visit.gateways.empty()) return std::nullopt;
  PlaceDisc result;
  for (const MeasuredGateway& gateway : visit.gateways)
    result.middle = result.middle + gateway.middle();
  result.middle = 1 / static_cast<double>(visit.gateways.size()) * result.middle;
  const auto away_m = [&](const MeasuredGateway& gateway) {
    return norm(gateway.middle() - result.middle);
  };
  result.radius_m = away_m(visit.gateways.front());
  for (const MeasuredGateway& gateway : visit.gateways)
    result.radius_m = std::min(result.radius_m, away_m(gateway));
  return result;
}

// Along the axes of S, with variances s and coordinates p of the point, the nearest x on the circle
// has x_k = p_k / (1 - m s_k): all are pushed outwards, the least certain most. |x| grows with m up
// to the pole 1 / max s; where the point has nothing along that axis, x may have anything.
double misfit_of_lying_apart(Point2 point, const PlaneCovariance& covariance, double least_m) {
  if (norm(point) >= least_m) return 0;
  const Point2 along = covariance.along();
  const double wide = std::max(covariance.middle() + covariance.half(), least_variance_m2);
  const double narrow = std::max(covariance.middle() - covariance.half(), least_variance_m2);
  const double p_wide = dot(along, point);
  const double p_narrow = cross(along, point);
  const auto x_at = [&](double m) {
    return Point2{p_wide / (1 - m * wide), p_narrow / (1 - m * narrow)};
  };
  double low = 0;
  double high = 1 / wide;
  for (int i = 0; i < 200; ++i) {
    const double middle = (low + high) / 2;
    (norm(x_at(middle)) < least_m ? low : high) = middle;
  }
  const double x_narrow = x_at(low).y_m;
  const double x_wide =
      std::copysign(std::sqrt(std::max(squared(least_m) - squared(x_narrow), 0.0)), p_wide);
  return squared(x_wide - p_wide) / wide + squared(x_narrow - p_narrow) / narrow;
}

// Seen from either place: so it does not matter which comes first.
std::vector<SharedSpot> shared_spots(std::span<const Pose2> layout_from_place,
                                     std::span<const PlaceDisplacement> displacements,
                                     std::span<const std::optional<PlaceDisc>> discs,
                                     double least_tail) {
  std::vector<SharedSpot> result;
  std::optional<LayoutCovariance> covariance;  // most layouts need none
  const double most = chi_squared_of_tail(least_tail, 1);
  for (std::size_t j = 0; j < layout_from_place.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      if (!discs[i] || !discs[j]) continue;
      const double least_m = discs[i]->radius_m + discs[j]->radius_m - most_overlap_m;
      const Point2 apart =
          layout_from_place[j] * discs[j]->middle - layout_from_place[i] * discs[i]->middle;
      if (norm(apart) >= least_m) continue;
      if (!covariance) covariance.emplace(layout_from_place, displacements);
      const LayoutCovariance::PlacePoint one{PlaceId(i), discs[i]->middle};
      const LayoutCovariance::PlacePoint other{PlaceId(j), discs[j]->middle};
      const double misfit =
          std::min(misfit_of_lying_apart(apart, covariance->seen_from(one, other), least_m),
                   misfit_of_lying_apart(apart, covariance->seen_from(other, one), least_m));
      if (misfit > most)
        result.push_back(
            {PlaceId(i), PlaceId(j), norm(apart), {misfit, 1, chi_squared_tail(misfit, 1)}});
    }
  }
  return result;
}

}  // namespace asterism
