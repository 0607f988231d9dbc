#pragma once

#include <cstddef>
#include <random>

namespace asterism {

/// Where all random numbers come from: the standard fixes the numbers of std::mt19937_64, but not
/// those of its distributions. The draws below are alike everywhere. One engine a thread.
using RandomEngine = std::mt19937_64;

/// Uniform in [0, 1).
inline double uniform(RandomEngine& engine) {
  return static_cast<double>(engine() >> 11U) * 0x1.0p-53;
}

/// Uniform in [low, high).
inline double between(double low, double high, RandomEngine& engine) {
  return low + (high - low) * uniform(engine);
}

/// True with the given probability.
inline bool chance(double probability, RandomEngine& engine) {
  return uniform(engine) < probability;
}

/// Mean 0, standard deviation 1: twelve uniform draws added up, near to normal and never beyond 6.
inline double normal(RandomEngine& engine) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += uniform(engine);
  return sum;
}

/// Uniform in 0 ... count - 1, for counts far below 2^53.   @pre count > 0
inline std::size_t below(std::size_t count, RandomEngine& engine) {
  return static_cast<std::size_t>(uniform(engine) * static_cast<double>(count));
}

}  // namespace asterism
