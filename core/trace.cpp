#include "core/trace.hpp"

#include <cmath>
#include <stdexcept>

namespace asterism {
namespace {

void require_gateway(const std::optional<std::size_t>& arm, const Star& star, bool is_required,
                     const std::string& where) {
  if (!arm) {
    if (is_required) throw std::invalid_argument(where + ": found nothing; expected an arm");
    return;
  }
  if (*arm >= star.size())
    throw std::invalid_argument(where + ": found arm " + std::to_string(*arm) +
                                "; expected one of " + std::to_string(star.size()));
  if (!star.has_gateway(*arm))
    throw std::invalid_argument(where + ": found " + star.name(*arm) +
                                ", which has no gateway; expected an arm with α = 1");
}

}  // namespace

bool is_covariance(const std::array<double, 9>& c) {
  constexpr double rounding = 1e-9;
  const auto deviation = [&](std::size_t i) { return std::sqrt(c[4 * i]); };
  for (const double number : c)
    if (!std::isfinite(number)) return false;
  for (std::size_t i = 0; i < 3; ++i)
    if (!(c[4 * i] >= 0)) return false;
  // Each of the principal minors must not be negative.
  std::array<double, 3> correlation{};  // of (0, 1), (0, 2), (1, 2)
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i + 1; j < 3; ++j) {
      const double above = c[3 * i + j];
      const double below = c[3 * j + i];
      const double scale = deviation(i) * deviation(j);
      if (std::abs(above - below) > rounding * scale) return false;
      if (std::abs(above) > (1 + rounding) * scale) return false;
      correlation[i + j - 1] = scale > 0 ? above / scale : 0;
    }
  }
  const auto [r, s, t] = correlation;
  return 1 + 2 * r * s * t - r * r - s * s - t * t >= -rounding;
}

void require_valid(const Trace& trace) {
  if (trace.visits.empty())
    throw std::invalid_argument("/visits: found none; expected at least one visit");
  for (std::size_t k = 0; k < trace.visits.size(); ++k) {
    const Visit& visit = trace.visits[k];
    const std::string where = "/visits/" + std::to_string(k);
    require_gateway(visit.entered_by, visit.star, k > 0, where + "/entered_by");
    require_gateway(visit.left_by, visit.star, k + 1 < trace.visits.size(), where + "/left_by");
  }
}

Trace reversed(const Trace& trace) {
  Trace result;
  result.name = trace.name;
  for (auto visit = trace.visits.rbegin(); visit != trace.visits.rend(); ++visit) {
    Visit back{.star = visit->star, .entered_by = visit->left_by, .left_by = visit->entered_by};
    back.true_place = visit->true_place;
    result.visits.push_back(std::move(back));
  }
  return result;
}

}  // namespace asterism
