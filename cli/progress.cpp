#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace asterism {
namespace {

using namespace std::chrono_literals;

constexpr auto until_first_line = 1500ms;
constexpr auto between_lines_on_terminal = 200ms;
constexpr auto between_lines = 5s;

volatile std::sig_atomic_t interrupted = 0;

}  // namespace

Progress::Progress(std::size_t visits, std::optional<double> time_limit_s)
    : visits_(visits), time_limit_s_(time_limit_s), is_terminal_(isatty(STDERR_FILENO) == 1) {
  // The first Ctrl-C stops in good order, a second at once.
  std::signal(SIGINT, [](int) {
    interrupted = 1;
    std::signal(SIGINT, SIG_DFL);
  });
}

Progress::~Progress() {
  std::signal(SIGINT, SIG_DFL);
  if (line_is_open_) std::fputc('\n', stderr);
}

bool Progress::operator()(std::size_t visit, std::uint64_t hypotheses) {
  return goes_on([&] {
    return fmt::format("{} maps of the visits up to {} of {} so far", hypotheses, visit,
                       visits_ - 1);
  });
}

bool Progress::searched(const MinimalSearch& search) {
  return goes_on([&] {
    const auto [at_least, best, count] = search.bounds();
    std::string text =
        fmt::format("{}s >= {} proved", search.options().axioms.preference().front(), at_least);
    if (best) text += fmt::format("; best so far {} paths, {} places", best->paths, best->places);
    return text;
  });
}

bool Progress::goes_on(const std::function<std::string()>& found) {
  const auto now = Clock::now();
  const double elapsed_s = std::chrono::duration<double>(now - begin_).count();
  if (interrupted != 0) stopped_by_ = "interrupt";
  if (time_limit_s_ && elapsed_s > *time_limit_s_) stopped_by_ = "time limit";
  if (stopped_by_) return false;
  const auto wait = shown_ == begin_ ? std::chrono::milliseconds(until_first_line)
                    : is_terminal_   ? std::chrono::milliseconds(between_lines_on_terminal)
                                     : std::chrono::milliseconds(between_lines);
  if (now - shown_ >= wait) {
    show(fmt::format("{:.0f} s: {}", elapsed_s, found()));
    shown_ = now;
  }
  return true;
}

void Progress::grown(const std::string& what_now) {
  std::signal(SIGINT, SIG_DFL);
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
