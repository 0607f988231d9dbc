#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/scan.hpp"
#include "io/line_words.hpp"
#include "io/log/carmen_log.hpp"

namespace asterism {

// What PARAM lines call what they say of the laser.
inline constexpr std::string_view resolution_parameter = "laser_front_laser_resolution";
inline constexpr std::string_view max_range_parameter = "robot_front_laser_max";
inline constexpr std::string_view x_parameter = "robot_frontlaser_offset";
inline constexpr std::string_view y_parameter = "robot_frontlaser_side_offset";
inline constexpr std::string_view heading_parameter = "robot_frontlaser_angular_offset";

inline constexpr Bounds offset_bounds{-100, 100};  ///< of a laser on a robot, metres or radians
inline constexpr Bounds range_bounds_m{0, 1e6};    ///< of a return

/// What ROBOTLASER1 says of its laser.
struct StatedLaser {
  double first_beam_rad = 0;
  double beam_step_rad = 0;
  double max_range_m = 0;
  Pose2 robot_from_laser = {};
};

/// How the beams of a log lie: what options, the log and, at last, the guesses that LogReader tells
/// of say.
class CarmenLaser {
 public:
  /// @throws std::invalid_argument if an option is not finite or out of its range
  explicit CarmenLaser(const LogOptions& options);

  /// Where to keep the value of a PARAM line, or nullptr for one that says nothing of the laser.
  std::optional<double>* parameter(std::string_view name);

  /// The layout of an FLASER line; to be asked in the order of the log.
  LaserLayout guessed(std::span<const double> ranges_m);
  /// The layout of a ROBOTLASER1 line.
  LaserLayout stated(const StatedLaser& laser, std::size_t beams) const;

 private:
  LaserLayout with_options(LaserLayout layout, std::size_t beams) const;
  double guessed_max_range_m(std::span<const double> ranges_m);

  LogOptions options_;
  std::optional<double> resolution_deg_;
  std::optional<double> max_range_m_;
  std::optional<double> x_m_, y_m_, heading_rad_;
  bool is_in_millimetres_ = false;  ///< some range was
  bool is_beyond_codes_ = false;    ///< some range was beyond the codes in millimetres
};

/// Where the first of so many beams is when nothing says it.
double guessed_first_beam_rad(std::size_t beams, double beam_step_rad);

}  // namespace asterism
