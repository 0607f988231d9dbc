#include "mapping/decisions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "io/picture/report_text.hpp"

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
  return (report.theory.assumptions.empty() ? "of all ways to match visits, "
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
    result.how = report.theory.planar ? "maps had to be drawable in the plane" : "not asked for";
    return result;
  }
  result.how = fmt::format("{}{} of these can be drawn in the plane",
                           report.theory.planar ? "" : "not asked for; ", count_text(*planar));
  if (report.theory.planar) result.count = *all - *planar;
  return result;
}

RunReport::Decision by_preference(const RunReport& report, std::uint64_t preferred) {
  const auto left = count(report, report.theory.planar);
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
  result.how = fmt::format(
      "against {} of the {} ranked, since layout or alignments are off by more than chance "
      "allows, or two places share a spot",
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

}  // namespace

std::vector<RunReport::Decision> decisions(const RunReport& report, std::uint64_t preferred) {
  std::vector<RunReport::Decision> result;
  if (!report.theory.assumptions.empty())
    result.push_back({"assumptions", "taken as known: " + text_of(report.theory.assumptions)});
  result.push_back({"axioms", axioms_text(report)});
  result.push_back(by_planarity(report));
  result.push_back(by_preference(report, preferred));
  if (!report.models.empty()) result.push_back(by_likelihood(report));
  return result;
}

}  // namespace asterism
