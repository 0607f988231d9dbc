#include "io/log/carmen_log.hpp"

#include <algorithm>
#include <filesystem>
#include <istream>

#include "core/error.hpp"
#include "io/line_words.hpp"
#include "io/log/carmen_laser.hpp"
#include "io/text_file.hpp"

namespace asterism {
namespace {

namespace fs = std::filesystem;

bool is_message_name(std::string_view word) {
  const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
  return is_capital(word.front()) && std::ranges::all_of(word, [&](char c) {
           return is_capital(c) || (c >= '0' && c <= '9') || c == '_';
         });
}

/// What ends every message; its stamp.
double read_stamp(LineWords& line) {
  const double stamp_s = line.number("ipc_timestamp");
  line.word("host");
  line.number("logger_timestamp");
  line.end("logger_timestamp");
  return stamp_s;
}

}  // namespace

class LogReader::Parser {
 public:
  Parser(std::unique_ptr<std::istream> in, const std::string& name, const LogOptions& options)
      : laser_(options), lines_(std::move(in), name) {}

  std::optional<Scan> next() {
    while (const auto text = lines_.next()) {
      LineWords line(*text, lines_);
      const std::string_view name = line.next_word();
      if (name.empty() || name.front() == '#') continue;
      if (name == "FLASER") {
        if (auto scan = counted(Kind::flaser, read_flaser(line))) return scan;
      } else if (name == "ROBOTLASER1") {
        if (auto scan = counted(Kind::robotlaser, read_robotlaser(line))) return scan;
      } else if (name == "ODOM") {
        line.pose("");
        for (const char* what : {"tv", "rv", "acceleration"}) line.number(what);
        read_stamp(line);
      } else if (name == "PARAM") {
        read_parameter(line);
      } else if (!is_message_name(name)) {
        line.refuse(name, "the name of a message, in capitals, or # and a comment");
      }
    }
    if (!kind_)
      throw InputError(lines_.name(), "no scan", "at least one line FLASER or ROBOTLASER1");
    return std::nullopt;
  }

  std::uint64_t bytes_read() const noexcept { return lines_.bytes_taken(); }

 private:
  enum class Kind { flaser, robotlaser };

  std::optional<Scan> counted(Kind kind, Scan scan) {
    if (!kind_) kind_ = kind;
    if (kind != kind_) return std::nullopt;
    scan.number = number_++;
    return scan;
  }

  Scan read_flaser(LineWords& line) {
    Scan scan;
    scan.ranges_m = line.numbers(line.count("the number of ranges", 1), "range", range_bounds_m);
    line.pose("");
    scan.odom_from_robot = line.pose("odom_");
    scan.stamp_s = read_stamp(line);
    scan.laser = laser_.guessed(scan.ranges_m);
    return scan;
  }

  Scan read_robotlaser(LineWords& line) {
    Scan scan;
    StatedLaser stated;
    line.number("laser_type");
    stated.first_beam_rad = line.number("start_angle", {-10, 10});
    line.number("field_of_view");
    stated.beam_step_rad = line.number("angular_resolution", {0, 10});
    stated.max_range_m = line.number("maximum_range", above_0);
    line.number("accuracy");
    line.number("remission_mode");
    scan.ranges_m = line.numbers(line.count("the number of ranges", 1), "range", range_bounds_m);
    if (scan.ranges_m.size() > 1 && stated.beam_step_rad == 0)
      line.refuse("0", "angular_resolution above 0 for more than one range");
    line.numbers(line.count("the number of remissions", 0), "remission");
    const Pose2 odom_from_laser = line.pose("laser_");
    scan.odom_from_robot = line.pose("robot_");
    stated.robot_from_laser = inverse(scan.odom_from_robot) * odom_from_laser;
    for (const char* name : {"tv", "rv", "forward_safety", "side_safety", "turn_axis"})
      line.number(name);
    scan.stamp_s = read_stamp(line);
    scan.laser = laser_.stated(stated, scan.ranges_m.size());
    return scan;
  }

  void read_parameter(LineWords& line) {
    const std::string name(line.word("the name of a parameter"));
    std::optional<double>* const value = laser_.parameter(name);
    if (!value) return;
    const bool is_length = name == max_range_parameter || name == resolution_parameter;
    *value = line.number(name, is_length ? above_0 : offset_bounds);
  }

  CarmenLaser laser_;
  LineReader lines_;
  std::optional<Kind> kind_;  ///< of the first scan
  long long number_ = 0;
};

LogReader::LogReader(const std::string& file, const LogOptions& options)
    : LogReader(opened_file(file), file, options) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return;
  const auto size = fs::file_size(file, error);
  if (!error) bytes_total_ = size;
}

LogReader::LogReader(std::unique_ptr<std::istream> in, const std::string& name,
                     const LogOptions& options)
    : parser_(std::make_unique<Parser>(std::move(in), name, options)) {}

LogReader::LogReader(LogReader&&) noexcept = default;
LogReader& LogReader::operator=(LogReader&&) noexcept = default;
LogReader::~LogReader() = default;

std::optional<Scan> LogReader::next() { return parser_->next(); }
std::uint64_t LogReader::bytes_read() const noexcept { return parser_->bytes_read(); }

}  // namespace asterism
