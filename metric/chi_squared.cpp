#include "metric/chi_squared.hpp"

#include <algorithm>
#include <cmath>

namespace asterism {

// With h = x / 2 and n degrees of freedom:  Σ_{i<n/2} e^-h hⁱ / i!  for even n, and
// erfc(√h) + Σ_{1<=i<=(n-1)/2} e^-h h^(i-1/2) / Γ(i+1/2)  for odd ones.      [AS64, 26.4.4, 26.4.5]
double chi_squared_tail(double chi_squared, std::size_t degrees_of_freedom) {
  if (degrees_of_freedom == 0 || chi_squared <= 0) return 1;
  const double half = chi_squared / 2;
  const bool odd = degrees_of_freedom % 2 == 1;
  double sum = odd ? std::erfc(std::sqrt(half)) : 0;
  for (std::size_t i = 0; i < degrees_of_freedom / 2; ++i) {
    const double power = static_cast<double>(i) + (odd ? 0.5 : 0.0);
    sum += std::exp(power * std::log(half) - half - std::lgamma(power + 1));
  }
  return std::min(sum, 1.0);
}

double chi_squared_of_tail(double tail_probability, std::size_t degrees_of_freedom) {
  if (degrees_of_freedom == 0) return 0;
  double low = 0;
  double high = 1;
  while (chi_squared_tail(high, degrees_of_freedom) > tail_probability) high *= 2;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (chi_squared_tail(middle, degrees_of_freedom) > tail_probability ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace asterism
