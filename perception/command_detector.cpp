#include "perception/command_detector.hpp"

#include <cstddef>
#include <deque>
#include <system_error>
#include <utility>

#include "perception/checked_detector.hpp"
#include "perception/child_process.hpp"
#include "perception/plugin_error.hpp"

namespace asterism {
namespace {

/// Visits not yet taken: where there are more, a program writes on and on and reads nothing.
constexpr std::size_t max_waiting = 100'000;

class CommandDetector : public PlaceDetector {
 public:
  CommandDetector(const DetectorProgram& command, std::string title, ScanWriter scan_line,
                  VisitReader read_visit_line)
      : title_(std::move(title)),
        scan_line_(std::move(scan_line)),
        read_visit_line_(std::move(read_visit_line)),
        patience_(command.patience_s),
        process_(command.command) {}

  std::string_view name() const noexcept override { return title_; }

  std::optional<DetectedVisit> observe(const Scan& scan) override {
    send(scan_line_(scan) + '\n');
    return next();
  }

  std::optional<DetectedVisit> finish() override {
    if (!finished_) {
      process_.close_input();
      hear_out();
      const auto ending = process_.ending(patience_);
      if (!ending) lose_patience();
      if (ending != "exit status 0") throw plugin_error(title_, *ending, "exit status 0");
      if (!line_.empty()) throw plugin_error(where(), "a line without its end", "a whole line");
      finished_ = true;
    }
    return next();
  }

 private:
  /// Reading whenever there is something to read keeps a program that writes from standing still,
  /// and us with it.
  void send(std::string_view text) {
    while (!text.empty()) {
      const auto ready = process_.wait(true, patience_);
      if (!ready.to_read && !ready.to_write) lose_patience();
      if (ready.to_read && !hear()) end_early();
      if (!ready.to_write) continue;
      const auto written = process_.write(text);
      if (!written) end_early();
      text.remove_prefix(*written);
    }
    while (process_.wait(false, ChildProcess::Duration(0)).to_read)
      if (!hear()) end_early();
  }

  /// Takes in all it still has to say.
  void hear_out() {
    do {
      if (!process_.wait(false, patience_).to_read) lose_patience();
    } while (hear());
  }

  /// Takes in what it has just said; false if that was the end.
  bool hear() {
    const auto text = process_.read();
    if (!text) return false;
    std::string_view rest = *text;
    for (std::size_t end; (end = rest.find('\n')) != rest.npos; rest.remove_prefix(end + 1)) {
      extend_line(rest.substr(0, end));
      take_line();
    }
    extend_line(rest);
    return true;
  }

  void extend_line(std::string_view part) {
    line_ += part;
    if (line_.size() > max_visit_line_bytes)
      throw plugin_error(where(), "more than " + std::to_string(max_visit_line_bytes) + " bytes",
                         "a shorter line");
  }

  void take_line() {
    if (visits_.size() == max_waiting)
      throw plugin_error(title_, std::to_string(max_waiting) + " visits ahead of the scans",
                         "one a scan at most");
    try {
      visits_.push_back({.visit = read_visit_line_(line_, where())});
    } catch (const Error& error) {
      throw PluginError(error.what());
    }
    ++lines_;
    line_.clear();
  }

  std::optional<DetectedVisit> next() {
    if (visits_.empty()) return std::nullopt;
    DetectedVisit first = std::move(visits_.front());
    visits_.pop_front();
    return first;
  }

  std::string where() const { return title_ + ":line " + std::to_string(lines_ + 1); }

  /// It reads no more, or writes no more. What it said before may tell why, and so comes first.
  [[noreturn]] void end_early() {
    process_.close_input();
    hear_out();
    const auto ending = process_.ending(patience_);
    if (ending && ending != "exit status 0") throw plugin_error(title_, *ending, "exit status 0");
    throw plugin_error(title_, "its input or output closed before the end of the scans",
                       "it to read them all");
  }

  [[noreturn]] void lose_patience() const {
    throw plugin_error(title_,
                       "nothing read, written or ended for " + seconds(patience_.count()) + " s",
                       "a program that goes on");
  }

  static std::string seconds(double number) {
    std::string text = std::to_string(number);
    text.erase(text.find_last_not_of('0') + 1);
    return text.ends_with('.') ? text.substr(0, text.size() - 1) : text;
  }

  std::string title_;
  ScanWriter scan_line_;
  VisitReader read_visit_line_;
  ChildProcess::Duration patience_;
  ChildProcess process_;
  std::string line_;  // begun, not ended
  std::deque<DetectedVisit> visits_;
  std::size_t lines_ = 0;
  bool finished_ = false;
};

}  // namespace

std::unique_ptr<PlaceDetector> command_detector(const DetectorProgram& command,
                                                ScanWriter scan_line, VisitReader read_visit_line) {
  const std::string title = one_line(command.command, 60);
  try {
    auto detector = std::make_unique<CommandDetector>(command, title, std::move(scan_line),
                                                      std::move(read_visit_line));
    return checked(std::move(detector), title);
  } catch (const std::system_error& error) {
    throw plugin_error(title, one_line(error.what()), "to start it");
  }
}

}  // namespace asterism
