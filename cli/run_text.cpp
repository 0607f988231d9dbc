#include "cli/run_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/json_value.hpp"
#include "io/report_text.hpp"

namespace asterism {
namespace {

std::size_t explained_visits(const RunReport& report) {
  return report.unexplained ? report.unexplained->visits : report.trace.visits.size();
}

/// How many maps explain the visits explained; absent where they were not counted.
std::optional<std::uint64_t> count(const RunReport& report, bool planar) {
  const auto& per_visit = planar ? report.planar_per_visit : report.all_per_visit;
  const std::size_t visits = explained_visits(report);
  if (visits == 0 || visits > per_visit.size()) return {};
  return per_visit[visits - 1];
}

std::string explains(std::uint64_t count) { return count == 1 ? " explains " : " explain "; }

std::string axioms_text(const RunReport& report) {
  const auto all = count(report, false);
  const std::string visits = report.unexplained
                                 ? fmt::format("the first {}", explained_visits(report))
                                 : "the " + counted(report.trace.visits.size(), "visit");
  return (report.assumptions.empty() ? "of all ways to match visits, "
                                     : "of the ways to match visits that are as assumed, ") +
         (all ? counted(*all, "map") + explains(*all) + visits
          : report.all_per_visit.empty() && report.planar_per_visit.empty()
              ? "the simplest were searched for, the others not counted"
              : "too many to count explain them");
}

RunReport::Decision by_planarity(const RunReport& report) {
  const auto all = count(report, false);
  const auto planar = count(report, true);
  RunReport::Decision result{"planarity"};
  if (!all || !planar) {
    result.how = report.planar ? "maps had to be drawable in the plane" : "not asked for";
    return result;
  }
  result.how = fmt::format("{}{} of these can be drawn in the plane",
                           report.planar ? "" : "not asked for; ", count_text(*planar));
  if (report.planar) result.count = *all - *planar;
  return result;
}

RunReport::Decision by_preference(const RunReport& report, std::uint64_t preferred) {
  const auto left = count(report, report.planar);
  return {"preference",
          counted(preferred, "map") + (preferred == 1 ? " has" : " have") +
              " the fewest paths, and of these the fewest places",
          left ? std::optional(*left - preferred) : std::nullopt};
}

bool are_equally_preferred(const TopologicalMap& a, const TopologicalMap& b) {
  return a.paths.size() == b.paths.size() && a.places.size() == b.places.size();
}

RunReport::Decision by_likelihood(const RunReport& report) {
  std::uint64_t implausible = 0;
  for (const RunReport::Model& model : report.models) implausible += !model.ranked.is_plausible;
  RunReport::Decision result{"likelihood", "", implausible};
  result.how =
      fmt::format("layout or alignments of {} of the {} ranked are off by more than chance allows",
                  implausible, report.models.size());
  const RankedMap& best = report.models.front().ranked;
  for (std::size_t i = 1; i < report.models.size(); ++i) {
    const RankedMap& next = report.models[i].ranked;
    if (!are_equally_preferred(best.map, next.map)) continue;
    result.how +=
        fmt::format("; rank 1 is {} times as likely as rank {}, the next of its size",
                    times_text(std::max(0.0, best.log_likelihood - next.log_likelihood)), i + 1);
    break;
  }
  return result;
}

/// One decimal, and no minus before zero.
double tenths(double value) { return std::round(10 * value) / 10 + 0.0; }

}  // namespace

std::vector<RunReport::Decision> decisions(const RunReport& report, std::uint64_t preferred) {
  std::vector<RunReport::Decision> result;
  if (!report.assumptions.empty())
    result.push_back({"assumptions", "taken as known: " + text_of(report.assumptions)});
  result.push_back({"axioms", axioms_text(report)});
  result.push_back(by_planarity(report));
  result.push_back(by_preference(report, preferred));
  if (!report.models.empty()) result.push_back(by_likelihood(report));
  return result;
}

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
  text += "rank 1 has its visits at places";
  for (const PlaceId place : report.models.front().ranked.map.visits)
    text += fmt::format(" {}", place.index());
  return text + '\n';
}

std::string summary_json(const RunReport& report, bool complete) {
  std::string text = fmt::format(
      "{{\n  \"scans\": {}, \"visits\": {}, \"explained_visits\": {}, \"consistent\": {}, "
      "\"complete\": {},\n",
      report.scans, report.trace.visits.size(), explained_visits(report),
      report.consistent ? fmt::format("{}", *report.consistent) : "null", complete);
  if (!report.assumptions.empty()) {
    std::string texts;
    for (const Assumption& assumption : report.assumptions)
      texts += (texts.empty() ? "" : ", ") + json_quoted(text_of(assumption));
    text += fmt::format("  \"assumptions\": [{}],\n", texts);
  }
  if (report.unexplained)
    text += fmt::format("  \"why\": {},\n", json_quoted(report.unexplained->why));
  text += "  \"models\": [";
  for (std::size_t i = 0; i < report.models.size(); ++i) {
    const RankedMap& ranked = report.models[i].ranked;
    std::string visits;
    for (const PlaceId place : ranked.map.visits)
      visits += fmt::format("{}{}", visits.empty() ? "" : ", ", place.index());
    text += fmt::format(
        "{}\n    {{ \"plausible\": {}, \"paths\": {}, \"places\": {}, \"chi_squared\": {}, "
        "\"degrees_of_freedom\": {}, \"tail_probability\": {}, \"log_likelihood\": {},\n"
        "      \"visits\": [{}] }}",
        i == 0 ? "" : ",", ranked.is_plausible, ranked.map.paths.size(), ranked.map.places.size(),
        ranked.misfit.chi_squared, ranked.misfit.degrees_of_freedom, ranked.misfit.tail_probability,
        ranked.log_likelihood, visits);
  }
  return text + "\n  ]\n}\n";
}

}  // namespace asterism
