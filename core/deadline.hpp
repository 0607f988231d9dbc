#pragma once

#include <algorithm>
#include <chrono>

namespace asterism {

/// When something must be over.
using Deadline = std::chrono::steady_clock::time_point;

/// @param seconds  from now; of more than three years, three years
inline Deadline deadline_in(double seconds) {
  using Clock = std::chrono::steady_clock;
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(
                            std::chrono::duration<double>(std::min(seconds, 1e8)));
}

inline bool is_over(Deadline deadline) { return std::chrono::steady_clock::now() >= deadline; }

inline double seconds_until(Deadline deadline) {
  return std::chrono::duration<double>(deadline - std::chrono::steady_clock::now()).count();
}

/// As solvers take it: at least 1, since 0 is no limit, and at most some ten days.
inline unsigned milliseconds_until(Deadline deadline) {
  return static_cast<unsigned>(std::clamp(1e3 * seconds_until(deadline), 1.0, 1e9));
}

}  // namespace asterism
