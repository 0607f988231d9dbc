#pragma once

#include <cstddef>

namespace asterism {

/// How often the sum of so many squared standard normal numbers is this large or larger.
/// Without degrees of freedom there is nothing to disagree: 1.
double chi_squared_tail(double chi_squared, std::size_t degrees_of_freedom);

/// The sum that is reached or passed so often.
/// @pre  0 < tail_probability < 1
double chi_squared_of_tail(double tail_probability, std::size_t degrees_of_freedom);

}  // namespace asterism
