#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fstream>

#include "cli/grow.hpp"
#include "cli/map_text.hpp"

namespace asterism {
namespace {

using namespace std::chrono_literals;

constexpr auto until_first_line = 1500ms;
constexpr auto between_lines_on_terminal = 200ms;
constexpr auto between_lines = 5s;

volatile std::sig_atomic_t received = 0;

/// The first signal stops in good order, a second at once.
void catch_signals() {
  for (const int signal : {SIGINT, SIGTERM})
    std::signal(signal, [](int number) {
      received = number;
      std::signal(number, SIG_DFL);
    });
}

void let_signals_end() {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
}

/// Of this program, resident; 0 where the system does not tell.
std::uint64_t memory_bytes() {
  std::ifstream statm("/proc/self/statm");
  std::uint64_t all = 0, resident = 0;
  statm >> all >> resident;
  return statm ? resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}

}  // namespace

Progress::Progress(std::size_t visits, std::optional<double> time_limit_s,
                   std::optional<std::uint64_t> memory_limit_bytes)
    : visits_(visits),
      time_limit_s_(time_limit_s),
      memory_limit_bytes_(memory_limit_bytes),
      is_terminal_(isatty(STDERR_FILENO) == 1) {
  catch_signals();
}

Progress::~Progress() {
  let_signals_end();
  if (line_is_open_) std::fputc('\n', stderr);
}

bool Progress::operator()(std::size_t visit, std::uint64_t hypotheses) {
  return (*this)([&] {
    return fmt::format("{} maps of the visits up to {} of {} so far", hypotheses, visit,
                       visits_ - 1);
  });
}

bool Progress::searched(const MinimalSearch& search) {
  return (*this)(
      [&] { return bounds_text(bounds_of(search), search.options().axioms.preference().front()); });
}

bool Progress::operator()(const std::function<std::string()>& known, std::uint64_t to_come) {
  const auto now = Clock::now();
  const double elapsed_s = std::chrono::duration<double>(now - begin_).count();
  if (received != 0) stopped_by_ = received == SIGINT ? "interrupt" : "termination";
  if (time_limit_s_ && elapsed_s > *time_limit_s_) stopped_by_ = "time limit";
  if (!has_room(to_come)) stopped_by_ = "memory limit";
  if (stopped_by_) return false;
  const auto wait = shown_ == begin_ ? std::chrono::milliseconds(until_first_line)
                    : is_terminal_   ? std::chrono::milliseconds(between_lines_on_terminal)
                                     : std::chrono::milliseconds(between_lines);
  if (now - shown_ >= wait) {
    show(fmt::format("{:.0f} s: {}", elapsed_s, known()));
    shown_ = now;
  }
  return true;
}

bool Progress::has_room(std::uint64_t bytes) const {
  // The rest is for what is found until it is asked again, and for writing it out.
  constexpr double share = 0.95;
  return !memory_limit_bytes_ || static_cast<double>(memory_bytes() + bytes) <=
                                     share * static_cast<double>(*memory_limit_bytes_);
}

std::optional<double> Progress::seconds_left() const {
  if (!time_limit_s_) return std::nullopt;
  const std::chrono::duration<double> elapsed = Clock::now() - begin_;
  return std::max(0.0, *time_limit_s_ - elapsed.count());
}

void Progress::grown(const std::string& what_now) {
  let_signals_end();
  if (Clock::now() - begin_ >= until_first_line) show(what_now);
}

void Progress::show(const std::string& line) {
  if (is_terminal_) {
    fmt::print(stderr, "\r{:<78}", line);
    line_is_open_ = true;
  } else {
    fmt::print(stderr, "{}\n", line);
  }
  std::fflush(stderr);
}

void StageTimes::operator()(const std::string& stage) {
  const auto now = std::chrono::steady_clock::now();
  fmt::print(stderr, "{}: {:.1f} s\n", stage, std::chrono::duration<double>(now - begin_).count());
  std::fflush(stderr);
  begin_ = now;
}

}  // namespace asterism
