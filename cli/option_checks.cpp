#include "cli/option_checks.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

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

}  // namespace asterism
