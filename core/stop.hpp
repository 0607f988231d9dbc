#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace asterism {

/// When something must be over.
using Deadline = std::chrono::steady_clock::time_point;

/// @param seconds  from now; of more than three years, three years
Deadline deadline_in(double seconds);
/// @return  below 0 where it is over
double seconds_until(Deadline deadline);
/// As solvers take it: at least 1, since 0 is no limit, and at most some ten days.
unsigned milliseconds_until(Deadline deadline);
/// Whether it has passed.
inline bool is_over(Deadline deadline) { return std::chrono::steady_clock::now() >= deadline; }

/// Bytes of memory that the program holds; 0 where the system does not tell.
std::uint64_t resident_bytes();

/// How far a piece of work is.
struct Standing {
  std::size_t visit = 0;   ///< in work
  std::uint64_t maps = 0;  ///< found or looked at so far
};

/// When a long piece of work ends, done or not; by default, when it is done. The work asks now and
/// then, from one thread at a time.
struct Stop {
  Deadline deadline = Deadline::max();             ///< max(): none
  std::optional<std::uint64_t> memory_bytes = {};  ///< that the program may hold
  double question_s = 10;                          ///< for each question to the solver
  /// Whoever watches says why to stop, if so.
  std::function<std::optional<std::string>(const Standing&)> watch = {};
  /// Why it was due, once it was: "time limit", "memory limit", or what the watcher said.
  mutable std::optional<std::string> reason = {};

  /// Whether to stop now.
  /// @param bytes_to_come  that will be needed on top of what is held
  bool is_due(const Standing& standing = {}, std::uint64_t bytes_to_come = 0) const;
  /// Whether the memory limit leaves room for so many bytes.
  bool has_room_for(std::uint64_t bytes) const;
  /// How long the next question to the solver may take.
  unsigned question_ms() const;
  /// A stop like this one, due in so many seconds at the latest.
  Stop within(double seconds) const;
};

}  // namespace asterism
