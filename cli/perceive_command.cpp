#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "cli/map_parts.hpp"
#include "cli/options.hpp"
#include "cli/place_pictures.hpp"
#include "core/error.hpp"
#include "io/detector_lines.hpp"
#include "io/grid_file.hpp"
#include "io/trace_file.hpp"
#include "perception/checked_detector.hpp"
#include "perception/command_detector.hpp"
#include "perception/shared_detector.hpp"

namespace asterism {
namespace {

namespace fs = std::filesystem;

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

/// The name without folder and without endings: drive of logs/drive.log.xz.
std::string stem_of(const std::string& file) {
  const std::string name = fs::path(file).filename().string();
  const std::string stem = name.substr(0, name.find('.', 1));
  return stem.empty() ? "log" : stem;
}

std::string row(std::size_t number, const Visit& visit) {
  const auto name = [&](const std::optional<std::size_t>& arm) {
    return arm ? visit.star.name(*arm) : std::string("-");
  };
  const std::string scans =
      visit.scans ? fmt::format("{} to {}", (*visit.scans)[0], (*visit.scans)[1]) : "-";
  return fmt::format("visit {:>3}  scans {:<16} in by {:<4} out by {:<4} star {}\n", number, scans,
                     name(visit.entered_by), name(visit.left_by), visit.star.text());
}

class Run {
 public:
  explicit Run(const PerceiveCommand& command) : command_(command) {
    if (command.plugin) {
      detector_ = load_detector(*command.plugin);
    } else if (command.program) {
      detector_ = command_detector({*command.program}, scan_line, read_visit_line);
    } else {
      auto own = std::make_unique<ScanDetector>(command.detector);
      own_ = own.get();
      detector_ = std::move(own);
    }
    trace_.name = stem_of(command.log);
  }

  int operator()() {
    LogReader log(command_.log, command_.laser);
    if (command_.output != "-") make_map_folder();
    std::size_t scans = 0;
    {
      ReadProgress progress;
      while (const std::optional<Scan> scan = log.next()) {
        if (auto visit = detector_->observe(*scan)) add(std::move(*visit));
        if (own_ && command_.plots_folder) pictures_.follow(*own_);
        progress(log, ++scans, trace_.visits.size());
      }
    }
    while (auto visit = detector_->finish()) add(std::move(*visit));
    if (trace_.visits.empty()) {
      throw InputError(command_.log, fmt::format("no place in {} scans", scans),
                       "a drive that visits one");
    }
    require_valid(trace_);
    if (command_.output == "-") {
      fmt::print("{}", trace_json(trace_));
    } else {
      write_trace_file(command_.output, trace_);
      tell(scans);
    }
    if (command_.plots_folder) pictures_.write(*command_.plots_folder, trace_.name);
    return exit_consistent;
  }

 private:
  void make_map_folder() {
    const fs::path output(command_.output);
    map_folder_ = output.parent_path() / (stem_of(command_.output) + ".lpm");
    make_folder(map_folder_);
  }

  void add(DetectedVisit detected) {
    if (own_ && command_.plots_folder) pictures_.add(detected, *own_);
    if (detected.place_map && command_.output != "-") {
      const std::string name = fmt::format("visit-{}.json", trace_.visits.size());
      write_grid_file((map_folder_ / name).string(), *detected.place_map);
      detected.visit.lpm = (map_folder_.filename() / name).string();
    }
    trace_.visits.push_back(std::move(detected.visit));
  }

  void tell(std::size_t scans) const {
    fmt::print("{}: {} scans, {} visits, {} travels\n", trace_.name, scans, trace_.visits.size(),
               trace_.visits.size() - 1);
    for (std::size_t i = 0; i < trace_.visits.size(); ++i) {
      fmt::print("  {}", row(i, trace_.visits[i]));
    }
  }

  const PerceiveCommand& command_;
  std::unique_ptr<PlaceDetector> detector_;
  ScanDetector* own_ = nullptr;  // the detector that ships, if it is that one
  PlacePictures pictures_;
  fs::path map_folder_;
  Trace trace_;
};

}  // namespace

int perceive_command(const PerceiveCommand& command) { return Run(command)(); }

}  // namespace asterism
