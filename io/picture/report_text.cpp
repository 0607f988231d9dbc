#include "io/picture/report_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asterism {
namespace {

constexpr const char* thin_gap = "\u202f";  // never a line's end

std::string power_of_ten(double mantissa, int exponent) {
  constexpr const char* raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = fmt::format("{:.0f}·10", mantissa);
  for (const char digit : std::to_string(exponent)) {
    text += digit == '-' ? "⁻" : raised[digit - '0'];
  }
  return text;
}

/// 10 to that power, one digit and the exponent.
std::string power_text(double logarithm_10) {
  double exponent = std::floor(logarithm_10);
  double mantissa = std::round(std::pow(10, logarithm_10 - exponent));
  if (mantissa >= 10) {
    mantissa /= 10;
    ++exponent;
  }
  return power_of_ten(mantissa, static_cast<int>(exponent));
}

}  // namespace

std::string decimals(double value, int digits) {
  std::string text = fmt::format("{:.{}f}", value, digits);
  const bool is_negative = text.starts_with('-');
  if (is_negative) text.erase(0, 1);
  const bool is_zero = text.find_first_not_of("0.") == std::string::npos;
  return is_negative && !is_zero ? "\u2212" + text : text;
}

std::string count_text(std::uint64_t count) {
  const std::string digits = std::to_string(count);
  if (digits.size() < 5) return digits;
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += thin_gap;
    text += digits[i];
  }
  return text;
}

std::string counted(std::uint64_t count, const std::string& word) {
  return count_text(count) + " " + word + (count == 1 ? "" : "s");
}

std::string probability_text(double probability) {
  if (probability >= 0.001) return decimals(probability, 3);
  return probability < 1e-9 ? "under 10⁻⁹" : power_text(std::log10(probability));
}

std::string times_text(double logarithm) {
  const double logarithm_10 = logarithm / std::numbers::ln10;
  if (logarithm_10 >= 6) return "over a million";
  const double times = std::exp(logarithm);
  if (times < 100) return decimals(times, 1);
  const double power = std::pow(10, std::floor(logarithm_10) - 1);  // two digits that count
  return count_text(static_cast<std::uint64_t>(std::round(times / power) * power));
}

std::string shared_spot_text(const SharedSpot& spot) {
  return fmt::format("places {} and {} lie on one spot, {:.2f} m apart", spot.one.index(),
                     spot.other.index(), spot.distance_m);
}

std::string ought_to_be_one_text(const TopologicalMap& map, const SharedSpot& spot) {
  const auto visits_to = [&](PlaceId place) {
    std::string visits;
    for (std::size_t k = 0; k < map.visits.size(); ++k)
      if (map.visits[k] == place) visits += fmt::format("{}{}", visits.empty() ? "" : ", ", k);
    return (std::ranges::count(map.visits, place) == 1 ? "visit " : "visits ") + visits;
  };
  return visits_to(spot.one) + " and " + visits_to(spot.other) + " ought to be one place";
}

std::string pieces_text(const TopologicalMap& map) {
  const auto pieces = pieces_of(map);
  std::string text = counted(pieces.size(), "piece");
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto [first, last] = pieces[i];
    text += i == 0 || i + 1 < pieces.size() ? ", of " : " and of ";
    text += first == last ? fmt::format("visit {}", first)
                          : fmt::format("visits {} to {}", first, last);
  }
  return text;
}

std::string pose_text(const Pose2& pose) {
  return fmt::format("{}, {} m, {}°", decimals(pose.x_m, 2), decimals(pose.y_m, 2),
                     decimals(pose.heading_rad * 180 / std::numbers::pi, 1));
}

std::string duration_text(double duration_s) {
  const auto seconds = static_cast<std::uint64_t>(std::max(0.0, std::round(duration_s)));
  if (seconds < 60) return fmt::format("{} s", seconds);
  if (seconds < 3600) return fmt::format("{} min {} s", seconds / 60, seconds % 60);
  return fmt::format("{} h {} min", count_text(seconds / 3600), seconds / 60 % 60);
}

std::string figure(const std::string& name, const std::string& value) {
  return fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", name, value);
}

std::string table(const std::vector<Column>& columns,
                  const std::vector<std::vector<std::string>>& rows) {
  const auto style = [](const Column& column) { return column.is_number ? " class=\"n\"" : ""; };
  std::string text = "<div class=\"scroll\"><table>\n<thead><tr>";
  for (const Column& column : columns) {
    text += fmt::format("<th{}>{}</th>", style(column), column.head);
  }
  text += "</tr></thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : rows) {
    text += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += fmt::format("<td{}>{}</td>", style(columns.at(i)), row[i]);
    }
    text += "</tr>\n";
  }
  return text + "</tbody>\n</table></div>\n";
}

std::string folding(const std::string& summary, const std::string& content, bool is_open) {
  return fmt::format("<details{}><summary>{}</summary>\n{}</details>\n",
                     is_open ? " open=\"open\"" : "", summary, content);
}

}  // namespace asterism
