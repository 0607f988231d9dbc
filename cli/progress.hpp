#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "core/stop.hpp"
#include "engine/minimal/minimal_search.hpp"
#include "io/log/carmen_log.hpp"
#include "mapping/trace_maps.hpp"

namespace asterism {

/// A line on stderr that tells how far long work is: on a terminal each replaces the one before.
class ProgressLine {
 public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ~ProgressLine();

  bool is_terminal() const { return is_terminal_; }
  void show(const std::string& line);

 private:
  bool is_terminal_;
  bool is_open_ = false;
};

/// Watches long work: tells on stderr how far it is, and when it must stop. SIGINT and SIGTERM stop
/// it in good order, the first time.
class Progress {
 public:
  Progress(std::size_t visits, std::optional<double> time_limit_s,
           std::optional<std::uint64_t> memory_limit_bytes = {});
  ~Progress();
  Progress(const Progress&) = delete;

  /// For work that tells of visits and maps.
  const Stop& stop() const { return stop_; }
  /// For work that tells of itself.
  /// @param known  what to tell; asked where it is time to
  Stop stop(std::function<std::string()> known);
  /// For a search of minimal models, which must outlive it.
  Stop stop(const MinimalSearch& search);
  /// For maps about to be found, which must outlive it.
  Stop stop(const TraceMaps& maps);
  /// Until the time limit; nothing if there is none.
  std::optional<double> seconds_left() const;
  /// Growing is over: a signal ends the program from now on. Tells what goes on, if the run has
  /// been long.
  void grown(const std::string& what_now);

 private:
  using Clock = std::chrono::steady_clock;

  std::optional<std::string> watch(const std::function<std::string()>& known);

  ProgressLine line_;
  Stop stop_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point shown_ = begin_;
};

/// Tells on stderr how far a log is read, if that takes long.
class ReadProgress {
 public:
  void operator()(const LogReader& log, std::size_t scans, std::size_t visits);

 private:
  using Clock = std::chrono::steady_clock;

  ProgressLine line_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point shown_ = begin_;
};

/// Tells on stderr how long each stage of a run took, once it is over.
class StageTimes {
 public:
  void operator()(const std::string& stage);

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace asterism
