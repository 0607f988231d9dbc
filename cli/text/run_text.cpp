#include "cli/text/run_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "io/picture/report_text.hpp"

namespace asterism {
namespace {

/// One decimal, and no minus before zero.
double tenths(double value) { return std::round(10 * value) / 10 + 0.0; }

/// The first few pairs, a line each, and how many more.
std::string shared_spots_text(const RankedMap& ranked, const std::string& rank) {
  constexpr std::size_t most = 3;
  const std::size_t told = std::min(most, ranked.shared_spots.size());
  std::string text;
  for (const SharedSpot& spot : std::span(ranked.shared_spots).first(told))
    text += fmt::format("{}{}; {}\n", rank, shared_spot_text(spot),
                        ought_to_be_one_text(ranked.map, spot));
  if (const std::size_t more = ranked.shared_spots.size() - told; more > 0)
    text += fmt::format("{}{} more {} of places share a spot\n", rank, more,
                        more == 1 ? "pair" : "pairs");
  return text;
}

}  // namespace

std::string ranking_text(const RunReport& report) {
  if (report.models.empty()) return {};
  std::string text = fmt::format("{:<17}{:>6}{:>8}{:>13}{:>9}{:>9}{:>16}\n", "rank", "paths",
                                 "places", "chi-squared", "freedom", "tail", "log-likelihood");
  for (std::size_t i = 0; i < report.models.size(); ++i) {
    const RankedMap& ranked = report.models[i].ranked;
    text += fmt::format("{:>4} {:<12}{:>6}{:>8}{:>13.1f}{:>9}{:>9.2g}{:>16.1f}\n", i + 1,
                        ranked.is_plausible ? "plausible" : "implausible", ranked.map.paths.size(),
                        ranked.map.places.size(), tenths(ranked.misfit.chi_squared),
                        ranked.misfit.degrees_of_freedom, ranked.misfit.tail_probability,
                        tenths(ranked.log_likelihood));
  }
  for (std::size_t i = 0; i < report.models.size(); ++i)
    text += shared_spots_text(report.models[i].ranked, fmt::format("rank {}: ", i + 1));
  text += "rank 1 has its visits at places";
  for (const PlaceId place : report.models.front().ranked.map.visits)
    text += fmt::format(" {}", place.index());
  return text + '\n';
}

}  // namespace asterism
