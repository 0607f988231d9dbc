#include "benchmarks/report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

namespace asterism {
namespace {

/// A number to so many significant digits, without exponent.
std::string digits(double number, int significant) {
  const int before_point = number > 0 ? static_cast<int>(std::floor(std::log10(number))) + 1 : 1;
  const int decimals = significant - before_point;
  if (decimals >= 0) return fmt::format("{:.{}f}", number, decimals);
  const double unit = std::pow(10, -decimals);
  return count_text(static_cast<std::uint64_t>(std::round(number / unit) * unit));
}

std::string row(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

}  // namespace

void Report::begin_table(std::string_view title, const std::vector<std::string>& columns) {
  markdown_ += fmt::format("\n{}\n\n{}|---|", title, row(columns));
  for (std::size_t i = 1; i < columns.size(); ++i) markdown_ += "--:|";
  markdown_ += '\n';
  fmt::print(stderr, "{}\n", title);
}

void Report::add_row(const std::vector<std::string>& cells) {
  markdown_ += row(cells);
  fmt::print(stderr, "  {}\n", fmt::join(cells, "  "));
}

void Report::add_text(std::string_view text) { markdown_ += fmt::format("\n{}\n", text); }

void Report::check(std::string_view what, std::optional<std::uint64_t> found,
                   std::uint64_t expected) {
  if (!found || *found == expected) return;
  counts_agree_ = false;
  fmt::print(stderr, "{}: found {} maps; expected {}\n", what, *found, expected);
}

void Report::require(bool holds, std::string_view what) {
  if (holds) return;
  counts_agree_ = false;
  fmt::print(stderr, "{}\n", what);
}

std::string duration_text(double seconds) {
  if (seconds < 1e-6) return digits(seconds * 1e9, 3) + " ns";
  if (seconds < 1e-3) return digits(seconds * 1e6, 3) + " µs";
  if (seconds < 1) return digits(seconds * 1e3, 3) + " ms";
  return digits(seconds, 3) + " s";
}

std::string count_text(std::uint64_t count) {
  std::string text = std::to_string(count);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, ",");
  return text;
}

std::string ratio_text(double ratio) { return digits(ratio, 2) + " ×"; }

}  // namespace asterism
