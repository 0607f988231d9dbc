#include "metric/chi_squared.hpp"

#include <cmath>

#include "core/random.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

// The tail by adding up the density, in steps fine enough for six digits.
double by_quadrature(double chi_squared, std::size_t degrees_of_freedom) {
  const double n = static_cast<double>(degrees_of_freedom);
  const auto density = [&](double x) {
    return std::exp((n / 2 - 1) * std::log(x) - x / 2 - n / 2 * std::log(2) - std::lgamma(n / 2));
  };
  const double end = chi_squared + 40 * std::sqrt(2 * n) + 200;
  constexpr int steps = 200000;
  const double step = (end - chi_squared) / steps;
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += density(chi_squared + (i + 0.5) * step) * step;
  return sum;
}

}  // namespace

// From the tables of [AS64, 26.8].
TEST_CASE("chi-squared tails are those of the tables", "[metric]") {
  CHECK(chi_squared_tail(3.84146, 1) == Approx(0.05).epsilon(1e-5));
  CHECK(chi_squared_tail(5.99146, 2) == Approx(0.05).epsilon(1e-5));
  CHECK(chi_squared_tail(16.2662, 3) == Approx(0.001).epsilon(1e-4));
  CHECK(chi_squared_tail(31.4104, 20) == Approx(0.05).epsilon(1e-5));
  CHECK(chi_squared_tail(0, 5) == 1);
  CHECK(chi_squared_tail(7, 0) == 1);
  CHECK(chi_squared_tail(1e6, 4) == 0);
}

TEST_CASE("chi-squared tails are what the density adds up to", "[metric]") {
  for (const std::size_t n : {3U, 4U, 7U, 18U, 101U, 600U}) {
    for (const double times : {0.5, 1.0, 1.3, 2.0}) {
      const double x = times * static_cast<double>(n);
      CHECK(chi_squared_tail(x, n) == Approx(by_quadrature(x, n)).epsilon(1e-5).margin(1e-12));
    }
  }
}

TEST_CASE("the sum of a tail has that tail", "[metric]") {
  for (const std::size_t n : {1U, 2U, 9U, 60U, 2000U}) {
    for (const double tail : {0.5, 0.05, 1e-3, 1e-9})
      CHECK(chi_squared_tail(chi_squared_of_tail(tail, n), n) == Approx(tail).epsilon(1e-6));
  }
}

TEST_CASE("squared normal numbers pass the tail as often as it says", "[metric]") {
  RandomEngine random(1);
  int passed = 0;
  constexpr int draws = 20000;
  const double bound = chi_squared_of_tail(0.1, 6);
  for (int i = 0; i < draws; ++i) {
    double sum = 0;
    for (int k = 0; k < 6; ++k) sum += std::pow(normal(random), 2);
    passed += sum >= bound ? 1 : 0;
  }
  CHECK(passed == Approx(0.1 * draws).margin(4 * std::sqrt(0.09 * draws)));
}

}  // namespace asterism
