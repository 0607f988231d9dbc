#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "benchmarks/minimal_methods.hpp"
#include "benchmarks/time_chart.hpp"
#include "core/trace.hpp"

namespace asterism {

/// What a method made of walks of one size, drawn by several seeds.
class MinimalRuns {
 public:
  void add(MinimalResult result) { results_.push_back(std::move(result)); }

  const std::vector<MinimalResult>& results() const { return results_; }
  std::size_t proved() const;
  std::size_t unproved() const { return results_.size() - proved(); }
  /// By time, what is not proved after all that is.
  /// @pre  there are some
  MinimalResult median() const;
  MinimalResult slowest() const { return by_time().back(); }
  /// @pre  there are some
  TimePoint point(std::size_t travels) const;

 private:
  std::vector<MinimalResult> by_time() const;

  std::vector<MinimalResult> results_;
};

/// One method, tried on walks that grow until it fails.
class MinimalMethod {
 public:
  struct Patience {
    std::size_t seeds;         ///< of each size
    std::size_t unproved = 1;  ///< of a size, then no further seeds
  };
  using Run = std::function<MinimalResult(const Trace&)>;

  MinimalMethod(std::string name, Patience patience, Run run)
      : name_(std::move(name)), patience_(patience), run_(std::move(run)) {}

  const std::string& name() const { return name_; }
  void next_size();
  /// Whether it is to be tried on one more walk of this size.
  bool goes_on() const;
  const MinimalResult& run(const Trace& trace);

  /// Of this size.
  const MinimalRuns& runs() const { return runs_; }

 private:
  std::string name_;
  Patience patience_;
  Run run_;
  bool has_failed_ = false;
  MinimalRuns runs_;
};

/// Whether what two methods say of one trace can both be true.
bool agree(const MinimalResult& one, const MinimalResult& other);

}  // namespace asterism
