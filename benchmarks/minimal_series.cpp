#include "benchmarks/minimal_series.hpp"

#include <algorithm>

namespace asterism {

std::size_t MinimalRuns::proved() const {
  return static_cast<std::size_t>(std::ranges::count_if(results_, &MinimalResult::is_proved));
}

std::vector<MinimalResult> MinimalRuns::by_time() const {
  std::vector<MinimalResult> sorted = results_;
  std::ranges::sort(sorted, {}, [](const MinimalResult& result) {
    return std::pair(!result.is_proved, result.seconds);
  });
  return sorted;
}

MinimalResult MinimalRuns::median() const { return by_time().at(results_.size() / 2); }

TimePoint MinimalRuns::point(std::size_t travels) const {
  const std::vector<MinimalResult> sorted = by_time();
  const MinimalResult middle = median();
  return {.x = static_cast<double>(travels),
          .seconds = middle.seconds,
          .fastest_s = sorted.front().seconds,
          .slowest_s = sorted.back().seconds,
          .is_open = !middle.is_proved};
}

void MinimalMethod::next_size() {
  has_failed_ = has_failed_ || (!runs_.results().empty() && !runs_.median().is_proved);
  runs_ = {};
}

bool MinimalMethod::goes_on() const {
  return !has_failed_ && runs_.results().size() < patience_.seeds &&
         runs_.unproved() < patience_.unproved;
}

const MinimalResult& MinimalMethod::run(const Trace& trace) {
  runs_.add(run_(trace));
  return runs_.results().back();
}

bool agree(const MinimalResult& one, const MinimalResult& other) {
  if (!one.is_proved && other.is_proved) return agree(other, one);
  if (other.at_least && one.best && one.best->paths < *other.at_least) return false;
  if (!one.is_proved) return true;
  if (!other.is_proved) return !other.best || (one.best && *one.best <= *other.best);
  return one.best == other.best && (!one.count || !other.count || *one.count == *other.count);
}

}  // namespace asterism
