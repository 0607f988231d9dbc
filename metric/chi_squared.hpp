#pragma once

#include <cstddef>

namespace asterism {

/// How often the sum of so many squared standard normal numbers is this large or larger.
///                                                                [AS64, 26.4.4, 26.4.5]
/// Without degrees of freedom there is nothing to disagree: 1.
double chi_squared_tail(double chi_squared, std::size_t degrees_of_freedom);

/// The sum of squared standard normal numbers that is reached or passed so often: the inverse of
/// chi_squared_tail(). Without degrees of freedom: 0.
///
/// @pre  0 < tail_probability < 1
double chi_squared_of_tail(double tail_probability, std::size_t degrees_of_freedom);

}  // namespace asterism
