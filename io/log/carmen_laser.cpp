#include "io/log/carmen_laser.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace asterism {
namespace {

constexpr double degree_rad = std::numbers::pi / 180;

constexpr double usual_max_range_m = 50;
// What SICK's LMS 200 tells in place of a range: 8183 means beyond its reach, up to 8191 other
// reasons; centimetres or millimetres, as it was set.
constexpr double lowest_code_m = 8.183;
constexpr double highest_code_m = 8.191;
constexpr double past_codes_m = 8.192;
constexpr double centimetres = 10;  // the same codes, ten times as far

constexpr double rounding = 1e-6;  // of decimals that went through a double

bool is_about(double a, double b) { return std::abs(a - b) < rounding; }

/// Of an unstated kind.
double guessed_step_rad(std::size_t beams) {
  switch (beams) {
    case 1:
      return 0;
    case 101:
    case 180:
    case 181:
      return degree_rad;
    case 201:
    case 360:
    case 361:
      return degree_rad / 2;
    case 400:
    case 401:
      return degree_rad / 4;
    default:
      return std::numbers::pi / static_cast<double>(beams - 1);
  }
}

/// A range from which on there is no return, if the laser is said to see that far.
double no_return_m(double max_range_m) {
  for (const double unit : {1.0, centimetres})
    if (max_range_m >= unit * lowest_code_m - rounding &&
        max_range_m <= unit * past_codes_m + rounding)
      return unit * lowest_code_m;
  return max_range_m;
}

void require(bool is_fit, const std::string& option, double found, const std::string& expected) {
  if (!is_fit)
    throw std::invalid_argument(option + ": found " + std::to_string(found) + "; expected " +
                                expected);
}

}  // namespace

double guessed_first_beam_rad(std::size_t beams, double beam_step_rad) {
  const double turn_rad = static_cast<double>(beams) * beam_step_rad;
  const bool is_last_left_out =
      is_about(turn_rad, 180 * degree_rad) || is_about(turn_rad, 100 * degree_rad);
  return -(is_last_left_out ? turn_rad : turn_rad - beam_step_rad) / 2;
}

CarmenLaser::CarmenLaser(const LogOptions& options) : options_(options) {
  constexpr double turn_rad = 2 * std::numbers::pi;
  if (const auto fov_rad = options.field_of_view_rad)
    require(*fov_rad > 0 && *fov_rad <= turn_rad, "field of view", *fov_rad,
            "an angle above 0, at most 2 pi");
  if (const auto first_rad = options.first_beam_rad)
    require(std::abs(*first_rad) <= turn_rad, "first beam", *first_rad,
            "an angle from -2 pi to 2 pi");
  if (const auto range_m = options.max_range_m)
    require(*range_m > 0 && std::isfinite(*range_m), "maximum range", *range_m, "metres above 0");
  if (const auto pose = options.robot_from_laser)
    for (const double number : {pose->x_m, pose->y_m, pose->heading_rad})
      require(std::isfinite(number), "laser offset", number, "finite numbers");
}

std::optional<double>* CarmenLaser::parameter(std::string_view name) {
  if (name == resolution_parameter) return &resolution_deg_;
  if (name == max_range_parameter) return &max_range_m_;
  if (name == x_parameter) return &x_m_;
  if (name == y_parameter) return &y_m_;
  if (name == heading_parameter) return &heading_rad_;
  return nullptr;
}

LaserLayout CarmenLaser::guessed(std::span<const double> ranges_m) {
  LaserLayout layout;
  layout.beam_step_rad =
      resolution_deg_ ? *resolution_deg_ * degree_rad : guessed_step_rad(ranges_m.size());
  layout.first_beam_rad = guessed_first_beam_rad(ranges_m.size(), layout.beam_step_rad);
  layout.max_range_m = max_range_m_ ? no_return_m(*max_range_m_) : guessed_max_range_m(ranges_m);
  layout.robot_from_laser = {x_m_.value_or(0), y_m_.value_or(0), heading_rad_.value_or(0)};
  return with_options(layout, ranges_m.size());
}

LaserLayout CarmenLaser::stated(const StatedLaser& laser, std::size_t beams) const {
  return with_options({laser.first_beam_rad, laser.beam_step_rad, no_return_m(laser.max_range_m),
                       laser.robot_from_laser},
                      beams);
}

LaserLayout CarmenLaser::with_options(LaserLayout layout, std::size_t beams) const {
  if (const auto fov_rad = options_.field_of_view_rad) {
    layout.beam_step_rad = beams > 1 ? *fov_rad / static_cast<double>(beams - 1) : 0;
    layout.first_beam_rad = beams > 1 ? -*fov_rad / 2 : 0;
  }
  layout.first_beam_rad = options_.first_beam_rad.value_or(layout.first_beam_rad);
  layout.max_range_m = options_.max_range_m.value_or(layout.max_range_m);
  layout.robot_from_laser = options_.robot_from_laser.value_or(layout.robot_from_laser);
  return layout;
}

double CarmenLaser::guessed_max_range_m(std::span<const double> ranges_m) {
  for (const double range_m : ranges_m) {
    const double centimetre = 100 * range_m;
    if (!is_about(centimetre, std::round(centimetre))) is_in_millimetres_ = true;
    if (range_m > highest_code_m + rounding) is_beyond_codes_ = true;
  }
  return is_in_millimetres_ && !is_beyond_codes_ ? lowest_code_m : usual_max_range_m;
}

}  // namespace asterism
