#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "engine/minimal_search.hpp"

namespace asterism {

/// Watches a long search: tells on stderr how far it is, and when it must stop. SIGINT and SIGTERM
/// stop it in good order, the first time.
class Progress {
 public:
  Progress(std::size_t visits, std::optional<double> time_limit_s,
           std::optional<std::uint64_t> memory_limit_bytes = {});
  ~Progress();
  Progress(const Progress&) = delete;

  /// @return whether to go on
  bool operator()(std::size_t visit, std::uint64_t hypotheses);
  /// The same of a search for minimal models.
  bool searched(const MinimalSearch& search);
  /// The same for any other search.
  /// @param known     what to tell; asked where it is time to
  /// @param to_come   bytes that will be needed on top of what is held
  bool operator()(const std::function<std::string()>& known, std::uint64_t to_come = 0);
  /// Whether the memory limit leaves room for so many bytes.
  bool has_room(std::uint64_t bytes) const;
  /// Until the time limit; nothing if there is none.
  std::optional<double> seconds_left() const;
  /// Growing is over: a signal ends the program from now on. Tells what goes on, if the run has
  /// been long.
  void grown(const std::string& what_now);
  /// Why it said to stop.
  const std::optional<std::string>& stopped_by() const { return stopped_by_; }

 private:
  using Clock = std::chrono::steady_clock;

  void show(const std::string& line);

  std::size_t visits_;
  std::optional<double> time_limit_s_;
  std::optional<std::uint64_t> memory_limit_bytes_;
  bool is_terminal_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point shown_ = begin_;
  bool line_is_open_ = false;
  std::optional<std::string> stopped_by_;
};

/// Tells on stderr how long each stage of a run took, once it is over.
class StageTimes {
 public:
  void operator()(const std::string& stage);

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace asterism
