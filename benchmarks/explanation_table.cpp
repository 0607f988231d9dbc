#include "benchmarks/explanation_table.hpp"

#include <algorithm>
#include <ctime>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/proof/explain.hpp"
#include "engine/tree/map_tree.hpp"

namespace asterism {
namespace {

constexpr double ample_s = 60;

std::set<std::pair<std::size_t, std::size_t>> pairs_at_one_place(const Trace& trace, bool planar) {
  MapTree tree({.planar = planar});
  tree.extend(trace.visits);
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  tree.for_each([&](HypothesisId, std::span<const Arrival> arrivals) {
    for (std::size_t j = 0; j < arrivals.size(); ++j)
      for (std::size_t i = 0; i < j; ++i)
        if (arrivals[i].place == arrivals[j].place) pairs.insert({i, j});
  });
  return pairs;
}

void add_row(Report& report, const Trace& trace, bool planar) {
  const auto possible = pairs_at_one_place(trace, planar);
  std::vector<double> times_s;
  std::uint64_t members = 0;
  const std::string name = trace.name + (planar ? ", planar" : "");
  const std::size_t visits = trace.visits.size();
  for (std::size_t j = 0; j < visits; ++j)
    for (std::size_t i = 0; i < j; ++i) {
      if (possible.contains({i, j})) continue;
      const std::vector<Claim> claims{{Claim::Same{VisitId(i), VisitId(j)}}};
      const std::clock_t begin = std::clock();
      const Reason reason = explain(trace, {.planar = planar}, claims, Stop{}.within(ample_s));
      if (reason.verdict != Verdict::inconsistent) continue;
      times_s.push_back(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
      members += reason.clash.members.size();
    }
  report.check(name + ", pairs explained", times_s.size(),
               visits * (visits - 1) / 2 - possible.size());
  if (times_s.empty()) return;
  std::ranges::sort(times_s);
  report.add_row({name, count_text(times_s.size()), std::to_string(members / times_s.size()),
                  duration_text(times_s[times_s.size() / 2]), duration_text(times_s.back())});
}

}  // namespace

void add_explanation_table(Report& report, std::span<const Trace> traces) {
  report.begin_table(
      "Why two visits were not to one place, each pair by itself, in processor time:",
      {"trace", "pairs", "members of a clash, mean", "time, median", "time, longest"});
  for (const Trace& trace : traces)
    for (const bool planar : {false, true}) add_row(report, trace, planar);
}

}  // namespace asterism
