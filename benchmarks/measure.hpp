#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

namespace asterism {

/// Wall time since it was made.
class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Median of what `run` returns, after two runs to warm up. At least `runs`; if it is more than
/// one, for half a second, in which what else the machine does evens out.
template <class F>
double median(std::size_t runs, F&& run) {
  for (int i = 0; i < 2; ++i) run();
  const Stopwatch stopwatch;
  std::vector<double> results;
  while (results.size() < runs || (runs > 1 && stopwatch.seconds() < 0.5)) results.push_back(run());
  std::ranges::sort(results);
  return results[results.size() / 2];
}

}  // namespace asterism
