#include "core/stop.hpp"

#include <algorithm>
#include <fstream>

namespace asterism {
namespace {

using Clock = std::chrono::steady_clock;

Deadline after(Deadline begin, double seconds) {
  constexpr double three_years_s = 1e8;
  return begin + std::chrono::duration_cast<Clock::duration>(
                     std::chrono::duration<double>(std::min(seconds, three_years_s)));
}

unsigned milliseconds(double seconds) {
  return static_cast<unsigned>(std::clamp(1e3 * seconds, 1.0, 1e9));
}

}  // namespace

Deadline deadline_in(double seconds) { return after(Clock::now(), seconds); }

double seconds_until(Deadline deadline) {
  return std::chrono::duration<double>(deadline - Clock::now()).count();
}

unsigned milliseconds_until(Deadline deadline) { return milliseconds(seconds_until(deadline)); }

std::uint64_t resident_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word != "VmRSS:") continue;
    std::uint64_t kibibytes = 0;
    return status >> kibibytes ? kibibytes * 1024 : 0;
  }
  return 0;
}

bool Stop::has_room_for(std::uint64_t bytes) const {
  // The rest is for what is found until it is asked again, and for writing it out.
  constexpr double share = 0.95;
  return !memory_bytes || static_cast<double>(resident_bytes() + bytes) <=
                              share * static_cast<double>(*memory_bytes);
}

bool Stop::is_due(const Standing& standing, std::uint64_t bytes_to_come) const {
  if (watch)
    if (auto why = watch(standing)) reason = std::move(why);
  if (is_over(deadline)) reason = "time limit";
  if (!has_room_for(bytes_to_come)) reason = "memory limit";
  return reason.has_value();
}

unsigned Stop::question_ms() const {
  return milliseconds(std::min(question_s, seconds_until(deadline)));
}

Stop Stop::within(double seconds) const {
  Stop sooner = *this;
  sooner.deadline = std::min(deadline, deadline_in(seconds));
  return sooner;
}

}  // namespace asterism
