#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>

#include "core/scan.hpp"

namespace asterism {

/// What a person knows of the laser; it overrules what the log says and what is guessed.
struct LogOptions {
  std::optional<double> field_of_view_rad = {};  ///< from the first beam to the last
  std::optional<double> first_beam_rad = {};  ///< absent, with a field of view: half of it, right
  std::optional<double> max_range_m = {};     ///< a range of this or more is no return
  std::optional<Pose2> robot_from_laser = {};
};

/// Reads the scans of a CARMEN log one at a time, in the order of the file. The file may be packed
/// by gzip or xz; its content tells. Memory does not grow with the log.
///
///   FLASER n r_1 ... r_n x y theta odom_x odom_y odom_theta ipc_timestamp host logger_timestamp
///   ROBOTLASER1 laser_type start_angle field_of_view angular_resolution maximum_range accuracy
///     remission_mode n r_1 ... r_n m s_1 ... s_m laser_x laser_y laser_theta robot_x robot_y
///     robot_theta tv rv forward_safety side_safety turn_axis ipc_timestamp host logger_timestamp
///   ODOM x y theta tv rv acceleration ipc_timestamp host logger_timestamp
///   PARAM name value ...
///   # a comment
///
/// A scan's pose is the wheels': odom_*, robot_*. Where a log has scans of both kinds, the kind of
/// its first scan is read and the other is checked only: they tell of one laser. ODOM is checked
/// only. A line that begins with any other word in capitals is another message of CARMEN's and
/// skipped; what begins otherwise is an error. So is a log without a scan, at its end.
///
/// An FLASER line does not say how its beams lie. Unless an option does:
/// - beam_step: laser_front_laser_resolution [degrees] of a PARAM line before it; else by the
/// number
///   of beams, as lasers by SICK have them: 180 or 181: 1°; 360 or 361: ½°; of 100°, 101: 1°, 201:
///   ½°, 400 or 401: ¼°; any other number lies over 180°, both ends included.
/// - first_beam: half the field of view to the right of ahead. Where steps as many as beams make
///   180° or 100°, the last beam was left out: the first is at -90° or -50°.
/// - max_range: robot_front_laser_max of a PARAM line; else 50 m, which is what lasers of that kind
///   were set to or beyond what they see (their no returns are 81.83 m to 81.91 m). But 8.183 m as
///   long as no range passes 8.191 m and some have been told to the millimetre: there the same
///   codes of no return, 8183 to 8191, are millimetres. A maximum range that is stated, here or in
///   ROBOTLASER1, as 81.83 m to 81.92 m or 8.183 m to 8.192 m is taken as the lowest of these
///   codes.
/// - robot_from_laser: robot_frontlaser_offset, _side_offset and _angular_offset [rad] of PARAM
/// lines;
///   else the laser is at the robot's origin. (x y theta are no help: logs may have them
///   corrected.)
/// Each rule looks back only, at what was read so far. For one thread at a time.
class LogReader {
 public:
  /// Reads a log from a file.
  /// @throws InputError if the file cannot be read, std::invalid_argument if an option is not
  /// finite
  ///         or out of its range
  explicit LogReader(const std::string& file, const LogOptions& options = {});
  /// Reads a log from a stream.
  /// @param name  for messages
  LogReader(std::unique_ptr<std::istream> in, const std::string& name,
            const LogOptions& options = {});
  LogReader(LogReader&&) noexcept;
  LogReader& operator=(LogReader&&) noexcept;
  ~LogReader();

  /// The next scan, nothing after the last.
  /// @throws InputError "file:line: found ...; expected ..."
  std::optional<Scan> next();

  /// How far it is: bytes of the file as it lies there, packed or not.
  std::uint64_t bytes_read() const noexcept;
  /// Absent where the file does not say, as a pipe.
  std::optional<std::uint64_t> bytes_total() const noexcept { return bytes_total_; }

 private:
  class Parser;
  std::unique_ptr<Parser> parser_;
  std::optional<std::uint64_t> bytes_total_;
};

/// Hands out one scan after the other, then nothing.
using ScanSource = std::function<std::optional<Scan>()>;

/// Writes scans as FLASER lines, with PARAM lines before them from which LogReader takes their
/// layout. Numbers have as many digits as they need to read back the same. All scans share one
/// layout, whose first beam is where LogReader looks for it.
/// @throws std::invalid_argument if a scan could not be read back, or there is none
void write_carmen_log(std::ostream& out, const ScanSource& next);

/// Writes a CARMEN log to a file, whole or not at all.
/// @throws std::invalid_argument for what could not be read back, Error if the file cannot be
/// written
void write_carmen_log(const std::string& file, const ScanSource& next);

}  // namespace asterism
