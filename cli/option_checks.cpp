#include "cli/option_checks.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace asterism {

/// CLI11 takes -1 for 2^64 - 1.
const CLI::Validator whole_number(
    [](const std::string& text) {
      const bool is_number = !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
        return c >= '0' && c <= '9';
      });
      return is_number ? "" : "found " + text + "; expected a whole number";
    },
    "");

/// CLI::Range takes NaN for one of its numbers, and spells out its bounds.
CLI::Validator number_between(double low, double high, const std::string& expected) {
  return CLI::Validator(
      [=](const std::string& text) {
        double value = 0;
        const bool is_fit = CLI::detail::lexical_cast(text, value) && std::isfinite(value) &&
                            value >= low && value <= high;
        return is_fit ? "" : "found " + text + "; expected " + expected;
      },
      "");
}
const CLI::Validator seconds = number_between(0, 1e9, "seconds, at least 0");

const CLI::Validator duration(
    [](std::string& text) {
      std::string number = text;
      if (number.ends_with('s')) number.pop_back();
      std::string error = seconds(number);
      if (!error.empty()) return "found " + text + "; expected seconds, at least 0";
      text = number;
      return error;
    },
    "");

const CLI::Validator memory_size(
    [](std::string& text) -> std::string {
      std::string_view number = text;
      constexpr std::string_view units = "KMG";
      std::uint64_t unit = 1;
      if (const auto found = number.empty() ? units.npos : units.find(number.back());
          found != units.npos) {
        unit = std::uint64_t{1024} << (10 * found);
        number.remove_suffix(1);
      }
      std::uint64_t value = 0;
      const char* const end = number.data() + number.size();
      const auto [read, error] = std::from_chars(number.data(), end, value);
      if (error != std::errc() || read != end || value == 0 || value > UINT64_MAX / unit)
        return "found " + text + "; expected bytes, or a number with K, M or G";
      text = std::to_string(value * unit);
      return "";
    },
    "");

}  // namespace asterism
