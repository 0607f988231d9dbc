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

/// Median of what `run` returns, `runs` times over, after two runs to warm up.
template <class F>
double median(std::size_t runs, F&& run) {
  for (int i = 0; i < 2; ++i) run();
  std::vector<double> results;
  for (std::size_t i = 0; i < runs; ++i) results.push_back(run());
  std::ranges::sort(results);
  return results[runs / 2];
}

}  // namespace asterism
