#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <utility>

#include "cli/text/map_text.hpp"

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

}  // namespace

ProgressLine::ProgressLine() : is_terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (is_open_) std::fputc('\n', stderr);
}

void ProgressLine::show(const std::string& line) {
  if (is_terminal_) {
    fmt::print(stderr, "\r{:<78}", line);
    is_open_ = true;
  } else {
    fmt::print(stderr, "{}\n", line);
  }
  std::fflush(stderr);
}

Progress::Progress(std::size_t visits, std::optional<double> time_limit_s,
                   std::optional<std::uint64_t> memory_limit_bytes) {
  catch_signals();
  if (time_limit_s) stop_.deadline = deadline_in(*time_limit_s);
  stop_.memory_bytes = memory_limit_bytes;
  stop_.watch = [this, last = visits - 1](const Standing& now) {
    return watch([&] {
      return fmt::format("{} maps of the visits up to {} of {} so far", now.maps, now.visit, last);
    });
  };
}

Progress::~Progress() { let_signals_end(); }

Stop Progress::stop(std::function<std::string()> known) {
  Stop result = stop_;
  result.watch = [this, known = std::move(known)](const Standing&) { return watch(known); };
  return result;
}

Stop Progress::stop(const TraceMaps& maps) {
  return maps.are_searched() ? stop(maps.search()) : stop_;
}

Stop Progress::stop(const MinimalSearch& search) {
  return stop([&] {
    return bounds_text(bounds_of(search),
                       name_of(search.options().theory.axioms.preference().front()));
  });
}

/// Why to stop, if a signal says so.
std::optional<std::string> Progress::watch(const std::function<std::string()>& known) {
  if (received != 0) return received == SIGINT ? "interrupt" : "termination";
  const auto now = Clock::now();
  const auto wait = shown_ == begin_      ? std::chrono::milliseconds(until_first_line)
                    : line_.is_terminal() ? std::chrono::milliseconds(between_lines_on_terminal)
                                          : std::chrono::milliseconds(between_lines);
  if (now - shown_ >= wait) {
    const double elapsed_s = std::chrono::duration<double>(now - begin_).count();
    line_.show(fmt::format("{:.0f} s: {}", elapsed_s, known()));
    shown_ = now;
  }
  return std::nullopt;
}

std::optional<double> Progress::seconds_left() const {
  if (stop_.deadline == Deadline::max()) return std::nullopt;
  return std::max(0.0, seconds_until(stop_.deadline));
}

void Progress::grown(const std::string& what_now) {
  let_signals_end();
  if (Clock::now() - begin_ >= until_first_line) line_.show(what_now);
}

void ReadProgress::operator()(const LogReader& log, std::size_t scans, std::size_t visits) {
  const auto now = Clock::now();
  if (now - shown_ < (line_.is_terminal() ? 300ms : 5s)) return;
  shown_ = now;
  const double elapsed_s = std::chrono::duration<double>(now - begin_).count();
  std::string share;
  if (log.bytes_total() && *log.bytes_total() > 0) {
    share = fmt::format("{:3.0f} % of the log, ", 100 * static_cast<double>(log.bytes_read()) /
                                                      static_cast<double>(*log.bytes_total()));
  }
  line_.show(fmt::format("{}{} scans, {:.0f} a second, {} visits", share, scans,
                         static_cast<double>(scans) / elapsed_s, visits));
}

void StageTimes::operator()(const std::string& stage) {
  const auto now = std::chrono::steady_clock::now();
  fmt::print(stderr, "{}: {:.1f} s\n", stage, std::chrono::duration<double>(now - begin_).count());
  std::fflush(stderr);
  begin_ = now;
}

}  // namespace asterism
