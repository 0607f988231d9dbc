#include "io/line_words.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/error.hpp"
#include "io/shown.hpp"

namespace asterism {
namespace {

constexpr std::string_view blanks = " \t\r";
constexpr std::size_t max_count = max_line_bytes / 2;  // a word takes two bytes

/// Nothing if the word is no number, or not within the bounds.
std::optional<double> number_of(std::string_view word, Bounds bounds) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool is_number = error == std::errc() && end == word.data() + word.size();
  if (!is_number || !bounds.contain(value)) return std::nullopt;
  return value;
}

std::string described(const std::string& name, Bounds bounds) {
  if (bounds.high == Bounds().high)
    return name + (bounds.low > 0 ? ", a number above 0" : ", a finite number");
  const auto text = [](double bound) { return std::to_string(static_cast<long long>(bound)); };
  return name + ", a number from " + text(bounds.low) + " to " + text(bounds.high);
}

}  // namespace

std::string_view LineWords::next_word() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
  const auto word = rest_.substr(0, rest_.find_first_of(blanks));
  rest_.remove_prefix(word.size());
  return word;
}

std::string_view LineWords::word(const std::string& name) {
  const auto word = next_word();
  if (word.empty()) refuse(word, name);
  return word;
}

double LineWords::number(const std::string& name, Bounds bounds) {
  const auto word = next_word();
  const auto value = number_of(word, bounds);
  if (!value) refuse(word, described(name, bounds));
  return *value;
}

std::size_t LineWords::count(const std::string& name, std::size_t smallest) {
  const auto word = next_word();
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool is_count = error == std::errc() && end == word.data() + word.size() && !word.empty();
  if (!is_count || value < smallest || value > max_count)
    refuse(word, name + ", an integer from " + std::to_string(smallest) + " to " +
                     std::to_string(max_count));
  return value;
}

std::uint64_t LineWords::integer(const std::string& name, std::uint64_t largest) {
  const auto word = next_word();
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool is_integer = error == std::errc() && end == word.data() + word.size() && !word.empty();
  if (!is_integer || value > largest)
    refuse(word, name + ", an integer from 0 to " + std::to_string(largest));
  return value;
}

std::vector<double> LineWords::numbers(std::size_t size, const std::string& name, Bounds bounds) {
  std::vector<double> result;
  result.reserve(std::min(size, rest_.size() / 2));  // the line may be shorter than it says
  while (result.size() < size) {
    const auto word = next_word();
    const auto value = number_of(word, bounds);
    if (!value)
      refuse(word, described(name + ' ' + std::to_string(result.size() + 1) + " of " +
                                 std::to_string(size),
                             bounds));
    result.push_back(*value);
  }
  return result;
}

Pose2 LineWords::pose(const std::string& name) {
  const double x_m = number(name + "x", position_bounds_m);
  const double y_m = number(name + "y", position_bounds_m);
  return {x_m, y_m, wrapped(number(name + "theta", heading_bounds_rad))};
}

double LineWords::planar_zero(const std::string& name) {
  constexpr double tolerance = 1e-3;
  const double value = number(name);
  if (!(std::abs(value) <= tolerance)) refuse(decimal(value), name + " 0 of a planar pose");
  return value;
}

void LineWords::end(const std::string& last) {
  const auto word = next_word();
  if (!word.empty()) refuse(word, "the end of the line after " + last);
}

void LineWords::refuse(std::string_view word, const std::string& expected) const {
  complain(word.empty() ? "the end of the line" : shown(word), expected);
}

void LineWords::complain(const std::string& found, const std::string& expected) const {
  throw InputError(reader_->where(), found, expected);
}

std::optional<LineWords> next_data_line(LineReader& reader) {
  while (const auto text = reader.next()) {
    const auto first = LineWords(*text, reader).next_word();
    if (!first.empty() && !first.starts_with('#')) return LineWords(*text, reader);
  }
  return std::nullopt;
}

}  // namespace asterism
