#include "cli/perceive_parts.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

#include "core/error.hpp"
#include "io/grid_file.hpp"

namespace asterism {
namespace {

/// Tells on stderr how far the log is read, if that takes long.
class ReadProgress {
 public:
  void operator()(const LogReader& log, std::size_t scans, std::size_t visits) {
    using namespace std::chrono_literals;
    const auto now = Clock::now();
    if (now - shown_ < (is_terminal_ ? 300ms : 5s)) return;
    shown_ = now;
    const double elapsed_s = std::chrono::duration<double>(now - begin_).count();
    std::string share;
    if (log.bytes_total() && *log.bytes_total() > 0) {
      share = fmt::format("{:3.0f} % of the log, ", 100 * static_cast<double>(log.bytes_read()) /
                                                        static_cast<double>(*log.bytes_total()));
    }
    const std::string line = fmt::format("{}{} scans, {:.0f} a second, {} visits", share, scans,
                                         static_cast<double>(scans) / elapsed_s, visits);
    if (is_terminal_) {
      fmt::print(stderr, "\r{:<78}", line);
      open_ = true;
    } else {
      fmt::print(stderr, "{}\n", line);
    }
    std::fflush(stderr);
  }
  ReadProgress() = default;
  ReadProgress(const ReadProgress&) = delete;
  ~ReadProgress() {
    if (open_) std::fputc('\n', stderr);
  }

 private:
  using Clock = std::chrono::steady_clock;
  bool is_terminal_ = isatty(STDERR_FILENO) == 1;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point shown_ = begin_;
  bool open_ = false;
};

}  // namespace

std::string stem_of(const std::string& file) {
  const std::string name = std::filesystem::path(file).filename().string();
  const std::string stem = name.substr(0, name.find('.', 1));
  return stem.empty() ? "log" : stem;
}

std::string visit_row(std::size_t number, const Visit& visit) {
  const auto name = [&](const std::optional<std::size_t>& arm) {
    return arm ? visit.star.name(*arm) : std::string("-");
  };
  const std::string scans =
      visit.scans ? fmt::format("{} to {}", (*visit.scans)[0], (*visit.scans)[1]) : "-";
  return fmt::format("visit {:>3}  scans {:<16} in by {:<4} out by {:<4} star {}\n", number, scans,
                     name(visit.entered_by), name(visit.left_by), visit.star.text());
}

std::size_t detect(LogReader& log, PlaceDetector& detector,
                   const std::function<void(const Scan&)>& followed,
                   const std::function<void(DetectedVisit)>& visited) {
  std::size_t scans = 0;
  std::size_t visits = 0;
  {
    ReadProgress progress;
    while (const std::optional<Scan> scan = log.next()) {
      if (auto visit = detector.observe(*scan)) {
        visited(std::move(*visit));
        ++visits;
      }
      followed(*scan);
      progress(log, ++scans, visits);
    }
  }
  while (auto visit = detector.finish()) visited(std::move(*visit));
  return scans;
}

void require_visits(const Trace& trace, const std::string& log, std::size_t scans) {
  if (trace.visits.empty())
    throw InputError(log, fmt::format("no place in {} scans", scans), "a drive that visits one");
  require_valid(trace);
}

std::string write_place_map(const std::filesystem::path& folder, std::size_t visit,
                            const Grid& place_map) {
  const std::string name = fmt::format("visit-{}.json", visit);
  write_grid_file((folder / name).string(), place_map);
  return (folder.filename() / name).string();
}

}  // namespace asterism
